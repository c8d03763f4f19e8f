// Automatic pairs of two meshes, and how far they are from a known correspondence.
//
//   spectral_pairs REFERENCE TEMPLATE [--vts REFERENCE.vts TEMPLATE.vts] [--rotations N] [--threads N] [--functions N]
//                [--mirror] [--partial]
//
// Line k of both .vts files is the vertex, counted from 1, that corresponds to line k of the other. Printed for every
// candidate: mean and share beyond 10 of the error, the distance along edges of the template between where a vertex
// ends and where it belongs, over the square root of the template's area, times 100; score; the pairs kept, with their
// share beyond 10.
// --partial searches the reference as a part of the template. --rotations turns the template N times at random and says
// in how many the pose from the pairs is the turn.

#include "alignment/pairs/find_pairs.h"
#include "alignment/partial/find_partial_pairs.h"
#include "alignment/pose/fit_pose.h"
#include "alignment/spectrum/edge_graph.h"
#include "base/parallel.h"
#include "geometry/io/read_shape.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <limits>
#include <map>
#include <random>

using namespace shellmatch;

namespace {

struct Arguments {
  std::vector<std::string> files, ids;
  int n_rotations = 0, n_landmarks = 0;
  bool is_partial = false;
  AlignmentOptions options;
};

Arguments parse(const std::vector<std::string>& words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto next = [&] { return i + 1 < words.size() ? words[++i] : std::string(); };
    if (words[i] == "--vts") {
      arguments.ids = {next()};
      arguments.ids.push_back(next());
    } else if (words[i] == "--rotations") {
      arguments.n_rotations = std::atoi(next().c_str());
    } else if (words[i] == "--threads") {
      set_n_threads(std::atoi(next().c_str()));
    } else if (words[i] == "--functions") {
      arguments.options.functions = std::atoi(next().c_str());
    } else if (words[i] == "--landmarks") {
      arguments.n_landmarks = std::atoi(next().c_str());
    } else if (words[i] == "--refined") {
      arguments.options.refined = std::atoi(next().c_str());
    } else if (words[i] == "--partial") {
      arguments.is_partial = true;
    } else if (words[i] == "--mirror") {
      arguments.options.mirror = true;
    } else {
      arguments.files.push_back(words[i]);
    }
  }
  return arguments;
}

std::vector<Index> read_ids(const std::string& path) {
  std::ifstream in(path);
  std::vector<Index> ids;
  for (Index id; in >> id;) ids.push_back(id - 1);
  return ids;
}

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Index nearest_vertex(const std::vector<Vec<3>>& vertices, const Vec<3>& x) {
  const auto nearer = [&](const Vec<3>& a, const Vec<3>& b) { return (a - x).squaredNorm() < (b - x).squaredNorm(); };
  return static_cast<Index>(std::min_element(vertices.begin(), vertices.end(), nearer) - vertices.begin());
}

/// Errors on the template, times 100 over the root of its area.
class TrueCorrespondence {
 public:
  TrueCorrespondence(const Surface<3>& reference, const Surface<3>& template_surface,
                     const std::vector<std::string>& files)
      : reference_(reference), template_(template_surface), graph_(template_surface) {
    if (files.size() == 2) {
      on_reference_ = read_ids(files[0]);
      on_template_ = read_ids(files[1]);
    } else if (reference.vertices.size() == template_surface.vertices.size()) {
      for (std::size_t v = 0; v < reference.vertices.size(); ++v) on_reference_.push_back(static_cast<Index>(v));
      on_template_ = on_reference_;
    }
    unit_ = std::sqrt(surface_measure(template_)) / 100;
  }

  /// \param turn that of the template before `found`
  std::vector<double> dense_errors(const AutomaticPairs& found, const PairCandidate& candidate,
                                   const Mat<3>& turn = Mat<3>::Identity()) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < on_reference_.size(); ++i) {
      const Index from = found.reference.nearest[on_reference_[i]];
      if (from == no_index) continue;
      const Vec<3> end = turn.transpose() * found.template_surface.surface.vertices[candidate.map[from]];
      errors.push_back(error(nearest(end), on_template_[i]));
    }
    return errors;
  }

  /// Some of the known pairs, evenly through their list.
  std::vector<CorrespondingPoints> landmarks(int n) const {
    std::vector<CorrespondingPoints> points;
    for (int k = 0; k < n; ++k) {
      const std::size_t i = static_cast<std::size_t>(k) * on_reference_.size() / static_cast<std::size_t>(n);
      points.push_back({reference_.vertices[on_reference_[i]], template_.vertices[on_template_[i]], 1});
    }
    return points;
  }

  std::vector<double> pair_errors(const PairCandidate& candidate) {
    std::map<Index, Index> known;
    for (std::size_t i = 0; i < on_reference_.size(); ++i) known[on_reference_[i]] = on_template_[i];
    std::vector<double> errors;
    for (const CorrespondingPoints& p : candidate.pairs)
      if (const auto at = known.find(nearest_vertex(reference_.vertices, p.on_reference)); at != known.end())
        errors.push_back(error(nearest_vertex(template_.vertices, p.on_template), at->second));
    return errors;
  }

 private:
  double error(Index end, Index belongs) {
    std::vector<double>& distances = distances_[end];
    if (distances.empty()) distances = graph_.distances_from(end);
    return distances[belongs] / unit_;
  }
  Index nearest(const Vec<3>& x) {
    const auto [at, is_new] = nearest_.try_emplace({x[0], x[1], x[2]}, no_index);
    if (is_new) at->second = nearest_vertex(template_.vertices, x);
    return at->second;
  }

  const Surface<3>&reference_, &template_;
  EdgeGraph graph_;
  double unit_ = 1;
  std::vector<Index> on_reference_, on_template_;
  std::map<Index, std::vector<double>> distances_;
  std::map<std::array<double, 3>, Index> nearest_;
};

struct ErrorFigures {
  double mean = std::numeric_limits<double>::quiet_NaN(), beyond = mean;
};
ErrorFigures figures_of(const std::vector<double>& errors) {
  ErrorFigures figures;
  if (errors.empty()) return figures;
  figures.mean = figures.beyond = 0;
  for (const double e : errors) {
    figures.mean += e / static_cast<double>(errors.size());
    figures.beyond += (e > 10 ? 100.0 : 0.0) / static_cast<double>(errors.size());
  }
  return figures;
}

void print(const AutomaticPairs& found, TrueCorrespondence& truth) {
  for (const PreparedSurface* prepared : {&found.reference, &found.template_surface})
    for (const std::string& note : prepared->notes) fmt::print("  {}\n", note);
  for (const PairCandidate& candidate : found.candidates) {
    const ErrorFigures dense = figures_of(truth.dense_errors(found, candidate)),
                       pairs = figures_of(truth.pair_errors(candidate));
    fmt::print("  error {:6.2f}, beyond 10 {:5.1f} %; score {:.3f}{}{}; {} pairs: error {:6.2f}, beyond 10 {:5.1f} %",
               dense.mean, dense.beyond, candidate.score, candidate.is_identity ? " as it lies" : "",
               candidate.is_mirrored ? " mirrored" : "", candidate.pairs.size(), pairs.mean, pairs.beyond);
    for (const MapScore& s : {candidate.coarse_score, candidate.score_parts})
      fmt::print(" | {:.3f} {:.3f} {:.3f} {:.3f} {:.3f}", s.functions, s.signature, s.orientation, s.pose, s.spin);
    fmt::print("\n");
  }
}

AutomaticPairs as_automatic(PartialPairs partial) {
  AutomaticPairs found{std::move(partial.part), std::move(partial.whole), {}};
  found.margin = partial.margin;
  for (PartialCandidate& c : partial.candidates) {
    PairCandidate& candidate = found.candidates.emplace_back();
    candidate.score = c.score;
    candidate.order = c.order;
    candidate.pairs = std::move(c.pairs);
    candidate.map = std::move(c.map);
  }
  return found;
}

Mat<3> random_rotation(std::mt19937& random) {
  const auto number = [&] { return random() / 4294967296.0 - 0.5; };
  Eigen::Quaterniond q(number(), number(), number(), number());
  while (q.norm() > 0.5 || q.norm() < 0.1) q = Eigen::Quaterniond(number(), number(), number(), number());
  return q.normalized().toRotationMatrix();
}

double angle_between(const Mat<3>& a, const Mat<3>& b) {
  return 180 / std::acos(-1.0) * Eigen::AngleAxisd(a.transpose() * b).angle();
}

/// The pose of the template as it lies is the truth from which every turned one is to differ by the turn.
void print_rotations(const Surface<3>& reference, const Surface<3>& template_surface, const Arguments& arguments,
                     TrueCorrespondence& truth) {
  std::mt19937 random(7);
  const Pose as_it_lies =
      fit_pose(find_pairs(reference, template_surface, arguments.options).pairs(), PoseKind::similarity);
  fmt::print("  as it lies: rotation {:.1f} degrees\n", angle_between(as_it_lies.rotation, Mat<3>::Identity()));
  for (int k = 0; k < arguments.n_rotations; ++k) {
    const Mat<3> turn = random_rotation(random);
    Surface<3> turned = template_surface;
    for (Vec<3>& x : turned.vertices) x = turn * x;
    const double start = seconds();
    const AutomaticPairs found = find_pairs(reference, turned, arguments.options);
    const Pose pose = fit_pose(found.pairs(), PoseKind::similarity);
    const double took = seconds() - start;
    fmt::print(
        "  turn {}: pose off by {:.1f} degrees from the turn, {:.1f} from turn and pose as it lies; error {:.2f}, "
        "score {:.3f}, margin {:.2f}, {:.1f} s\n",
        k, angle_between(pose.rotation, turn), angle_between(pose.rotation, turn * as_it_lies.rotation),
        figures_of(truth.dense_errors(found, found.candidates[0], turn)).mean, found.candidates[0].score, found.margin,
        took);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const Arguments arguments = parse({argv + 1, argv + argc});
  if (arguments.files.size() != 2) {
    fmt::print(stderr,
               "usage: spectral_pairs REFERENCE TEMPLATE [--vts REFERENCE.vts TEMPLATE.vts] [--rotations N] "
               "[--threads N] [--functions N] [--mirror] [--partial]\n");
    return 2;
  }
  const Surface<3> reference = read_triangles(arguments.files[0]),
                   template_surface = read_triangles(arguments.files[1]);
  TrueCorrespondence truth(reference, template_surface, arguments.ids);
  if (arguments.n_rotations > 0) {
    print_rotations(reference, template_surface, arguments, truth);
    return 0;
  }
  const double start = seconds();
  const std::clock_t cpu_start = std::clock();
  const std::vector<CorrespondingPoints> landmarks = truth.landmarks(arguments.n_landmarks);
  const AutomaticPairs found =
      arguments.is_partial ? as_automatic(find_partial_pairs(reference, template_surface, arguments.options, landmarks))
                           : find_pairs(reference, template_surface, arguments.options, landmarks);
  const double took = seconds() - start, cpu = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  const ErrorFigures dense = figures_of(truth.dense_errors(found, found.candidates[0]));
  fmt::print("error {:.2f}, beyond 10 {:.1f} %, score {:.3f}, margin {:.2f}, {:.2f} s, CPU {:.2f} s\n", dense.mean,
             dense.beyond, found.candidates[0].score, found.margin, took, cpu);
  print(found, truth);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "spectral_pairs: {}\n", error.what());
  return 1;
}
