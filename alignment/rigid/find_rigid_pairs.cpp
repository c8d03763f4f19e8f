#include "alignment/rigid/find_rigid_pairs.h"

#include "alignment/pairs/order_candidates.h"
#include "base/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shellmatch {

namespace {

// Triangulations of one surface differ by less.
constexpr double score_noise = 0.005;
constexpr double identity_angle = 0.175;  // 10 degrees
constexpr std::size_t n_few_samples = 150, n_samples = 600;

struct SearchedMotion {
  RigidMotion motion;
  RigidScore score;
  bool is_identity = false;
};

double angle_of(const Mat<3>& rotation) { return std::acos(std::clamp((rotation.trace() - 1) / 2, -1.0, 1.0)); }

/// Rotations spread evenly: a spiral of unit quaternions (M. Alexa: Super-Fibonacci spirals: fast, low-discrepancy
/// sampling of SO(3). CVPR 2022).
std::vector<Mat<3>> rotations_all_around(int n) {
  const double phi = std::numbers::sqrt2, psi = 1.533751168755204288118041;
  std::vector<Mat<3>> rotations;
  for (int i = 0; i < n; ++i) {
    const double s = i + 0.5, r = std::sqrt(s / n), big = std::sqrt(1 - s / n);
    const double alpha = 2 * std::numbers::pi * s / phi, beta = 2 * std::numbers::pi * s / psi;
    rotations.push_back(
        Eigen::Quaterniond(r * std::sin(alpha), r * std::cos(alpha), big * std::sin(beta), big * std::cos(beta))
            .toRotationMatrix());
  }
  return rotations;
}

/// The 24 rotations of a cube.
std::vector<Mat<3>> cube_rotations() {
  std::vector<Mat<3>> rotations;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Mat<3> m = Mat<3>::Zero();
      for (int k = 0; k < 3; ++k) m(order[k], k) = signs >> k & 1 ? -1 : 1;
      if (m.determinant() > 0) rotations.push_back(m);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return rotations;
}

std::vector<RigidMotion> rigid_starts(const NormalizedSurface& first, const NormalizedSurface& second) {
  std::vector<RigidMotion> starts{{}};
  for (const Mat<3>& m : cube_rotations())
    starts.push_back({second.axes() * m * first.axes().transpose(), Vec<3>::Zero()});
  for (const Mat<3>& rotation : rotations_all_around(144)) starts.push_back({rotation, Vec<3>::Zero()});
  return starts;
}

/// The best motions and the one as the surfaces lie, all by more than `alike` radians apart.
std::vector<SearchedMotion> distinct_motions(std::vector<SearchedMotion> motions, std::size_t n_most, double alike) {
  std::stable_sort(motions.begin(), motions.end(),
                   [](const SearchedMotion& a, const SearchedMotion& b) { return a.score.total() < b.score.total(); });
  std::vector<SearchedMotion> distinct;
  for (const SearchedMotion& m : motions) {
    const auto same = std::find_if(distinct.begin(), distinct.end(), [&](const SearchedMotion& other) {
      return angle_of(m.motion.rotation.transpose() * other.motion.rotation) < alike;
    });
    if (same != distinct.end()) same->is_identity |= m.is_identity;
    else if (distinct.size() < n_most || m.is_identity) distinct.push_back(m);
  }
  return distinct;
}

void improve(std::vector<SearchedMotion>& motions, const SampledPair& pair, int n_sweeps, std::size_t chunk_size) {
  parallel_for(
      motions.size(),
      [&](std::size_t i) {
        motions[i].motion = iterated_points(pair, motions[i].motion, n_sweeps);
        motions[i].score = rigid_score(pair, motions[i].motion);
      },
      chunk_size);
}

std::vector<SearchedMotion> search_motions(const NormalizedSurface& first, const NormalizedSurface& second,
                                           std::size_t n_most, int n_sweeps) {
  const auto nearest_on = [](const auto& points) { return [&](const Vec<3>& x) { return points.nearest(x); }; };
  const SampleCloud on_first(first.samples(n_samples)), on_second(second.samples(n_samples));
  const SampledPair few{first.samples(n_few_samples), second.samples(n_few_samples), nearest_on(on_first),
                        nearest_on(on_second)};
  const SampledPair many{on_first.samples(), on_second.samples(), nearest_on(first), nearest_on(second)};
  std::vector<SearchedMotion> motions;
  for (const RigidMotion& start : rigid_starts(first, second)) motions.push_back({start, {}});
  improve(motions, few, 6, 4);
  // Not yet converged: what is nearer than the starts are to each other may lead to the same pose.
  motions = distinct_motions(std::move(motions), 3 * n_most, 0.4);
  improve(motions, many, 4, 1);
  motions = distinct_motions(std::move(motions), n_most + 2, identity_angle);
  improve(motions, many, n_sweeps, 1);
  // Near-spheres would drift: the surfaces as they lie are judged as they lie.
  motions.push_back({{}, rigid_score(many, {}), true});
  return distinct_motions(std::move(motions), n_most, identity_angle);
}

std::vector<CorrespondingPoints> nearest_pairs(const NormalizedSurface& first, const NormalizedSurface& second,
                                               const RigidMotion& motion, std::size_t n) {
  std::vector<CorrespondingPoints> pairs;
  for (const SurfacePoint& x : first.samples(n)) {
    const SurfacePoint y = second.nearest(motion(x.point));
    const double agreement = (motion.rotation * x.normal).dot(y.normal);
    // Sides that face each other by less than 70 degrees are no partners.
    if (agreement > 0.34)
      pairs.push_back({first.centre() + first.radius() * x.point, second.centre() + second.radius() * y.point,
                       agreement * agreement});
  }
  return pairs;
}

std::vector<RigidCandidate> rigid_candidates(const Surface<3>& reference, const NormalizedSurface& second,
                                             const AlignmentOptions& options, int n_sweeps, bool is_mirrored) {
  const Vec<3> sides(is_mirrored ? -1 : 1, 1, 1);
  Surface<3> shown = reference;
  if (is_mirrored) {
    for (Vec<3>& x : shown.vertices) x.x() *= -1;
    for (auto& facet : shown.facets) std::swap(facet[0], facet[1]);
  }
  const NormalizedSurface first(shown);
  std::vector<RigidCandidate> candidates;
  for (const SearchedMotion& found :
       search_motions(first, second, static_cast<std::size_t>(options.refined), n_sweeps)) {
    RigidCandidate& candidate = candidates.emplace_back();
    candidate.score_parts = found.score;
    candidate.score = found.score.total();
    candidate.is_identity = found.is_identity && !is_mirrored;
    candidate.is_mirrored = is_mirrored;
    candidate.pairs = nearest_pairs(first, second, found.motion, static_cast<std::size_t>(options.pairs));
    for (CorrespondingPoints& pair : candidate.pairs) pair.on_reference = sides.cwiseProduct(pair.on_reference);
    candidate.pose.rotation = found.motion.rotation * sides.asDiagonal();
    candidate.pose.scale = second.radius() / first.radius();
    candidate.pose.translation = second.centre() + second.radius() * found.motion.offset -
                                 candidate.pose.scale * (found.motion.rotation * first.centre());
    if (!candidate.pairs.empty()) candidate.pose.residual = median_distance(candidate.pairs, candidate.pose);
  }
  return candidates;
}

/// Whether the poses differ by a motion that carries the template onto itself.
bool differ_by_symmetry(const NormalizedSurface& surface, const Pose& a, const Pose& b) {
  constexpr double tolerance = 0.01;
  double sum = 0;
  const std::vector<SurfacePoint> samples = surface.samples(n_samples);
  for (const SurfacePoint& sample : samples) {
    const Vec<3> x =
        (b(a.inverse(surface.centre() + surface.radius() * sample.point)) - surface.centre()) / surface.radius();
    sum += (surface.nearest(x).point - x).norm();
  }
  return sum < tolerance * static_cast<double>(samples.size());
}

}  // namespace

RigidPairs find_rigid_pairs(const Surface<3>& reference, const Surface<3>& template_surface,
                            const AlignmentOptions& options, int n_sweeps) {
  RigidPairs result;
  std::vector<RigidCandidate>& candidates = result.candidates;
  const NormalizedSurface second(template_surface);
  candidates = rigid_candidates(reference, second, options, n_sweeps, false);
  if (options.mirror)
    for (RigidCandidate& candidate : rigid_candidates(reference, second, options, n_sweeps, true))
      candidates.push_back(std::move(candidate));
  order_candidates(candidates, {options.identity_preference, score_noise}, [](const RigidCandidate& c) {
    return angle_of(c.is_mirrored ? Mat<3>(-c.pose.rotation) : c.pose.rotation);
  });
  result.margin = margin_of_first(candidates, score_noise, [&](const RigidCandidate& a, const RigidCandidate& b) {
    return differ_by_symmetry(second, a.pose, b.pose);
  });
  return result;
}

}  // namespace shellmatch
