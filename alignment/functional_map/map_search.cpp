#include "alignment/functional_map/map_search.h"

#include "alignment/clear_margin.h"
#include "alignment/functional_map/mirrored_gain.h"
#include "alignment/functional_map/starts.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/distance/surface_distance.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

namespace shellmatch {

namespace {

// Samples, beside landmarks.
constexpr std::size_t n_queries = 250;
constexpr std::size_t n_refined_queries = 1000;
constexpr int n_merged = 9;   // functions at which starts are compared
constexpr int n_smooth = 24;  // functions of the coordinates that are rotated
constexpr int n_scored = 40;  // functions at which candidates are compared
// Candidates that go on from the first steps to the last. With 12 to 64 of them, after three to five steps, eighteen
// pairs of animals and people end alike.
constexpr int n_promising = 16;
constexpr std::size_t n_tip_starts = 24;
// Of distances from tips beside functions of mean square 1, for a map that began with tips.
constexpr double tip_weight = 5;
const std::vector<int> first_steps = {9, 11, 13}, last_steps = {16, 20, 25, 32, n_scored};
constexpr double least_landmark_scale =
    0.05;  // distance at which a landmark has half its weight at least, in roots of the area

/// Adds the rows that hold a map near the tips that it began with, if it did.
void append_tips(const MapCandidate& candidate, const VertexSet (&sets)[2], Embedding& embedding) {
  const Eigen::Index m = candidate.tips[0].rows();
  if (m == 0) return;
  for (int s = 0; s < 2; ++s) {
    Features& features = embedding.on[s];
    features.conservativeResize(features.rows() + m, static_cast<Eigen::Index>(sets[s].size()));
    for (std::size_t i = 0; i < sets[s].size(); ++i)
      features.col(static_cast<Eigen::Index>(i)).tail(m) =
          static_cast<float>(tip_weight) * candidate.tips[s].col(sets[s].vertices[i]);
  }
}

/// Alternates nearest neighbours and functional maps for every number of functions in `steps`.
void upsample(const ShapePairSpectra& pair, const std::vector<int>& steps, double normal_weight,
              MapCandidate& candidate) {
  for (const int k : steps) {
    if (k > candidate.c.rows()) candidate.c = orthogonal_map(pair, candidate.matches, std::min(k, pair.n_functions));
    const VertexSet(&sets)[2] = k <= first_steps.back() ? pair.coarsest : pair.coarse;
    Embedding embedding = spectral_embedding(pair, sets, candidate.c, normal_weight);
    append_tips(candidate, sets, embedding);
    candidate.matches = match_vertices(sets, embedding, pair.landmarks.size() + n_queries);
  }
}

/// Mean distance on surface 2, in roots of its area, between the images of the same vertices.
double difference(const ShapePairSpectra& pair, const VertexMatches& a, const VertexMatches& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.to[0].size(); ++i)
    sum += (pair.shapes[1]->surface.vertices[a.to[0][i]] - pair.shapes[1]->surface.vertices[b.to[0][i]]).norm();
  return sum / static_cast<double>(std::max<std::size_t>(1, a.to[0].size()));
}

/// Leaves out candidates that nearly equal an earlier one, which then counts as that of the surfaces as they lie if
/// either does. That by landmarks, which may be noisy, has to equal it more nearly.
std::vector<MapCandidate> distinct(const ShapePairSpectra& pair, std::vector<MapCandidate> candidates) {
  std::vector<MapCandidate> kept;
  for (MapCandidate& candidate : candidates) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const MapCandidate& other) {
      const double tolerance = candidate.is_by_landmarks != other.is_by_landmarks ? 0.01 : 0.05;
      return difference(pair, candidate.matches, other.matches) < tolerance;
    });
    if (same == kept.end()) kept.push_back(std::move(candidate));
    else {
      same->is_identity |= candidate.is_identity;
      same->is_by_landmarks |= candidate.is_by_landmarks;
    }
  }
  return kept;
}

/// Adds six rows for the vertices of `set`: their rotated smooth coordinates and their rotated normals, weighted.
void append_rotated(const SpectralShape& shape, const Columns4& smoothed, const VertexSet& set, const Mat<3>& rotation,
                    Features& features) {
  constexpr double coordinate_weight = 3, normal_weight = 0.5;
  const Eigen::Index k = features.rows();
  features.conservativeResize(k + 6, static_cast<Eigen::Index>(set.size()));
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Index v = set.vertices[i];
    const Vec<3> x = smoothed.col(v).head<3>().cast<double>();
    const Vec<3> normal = shape.normals.row(v).transpose();
    auto column = features.col(static_cast<Eigen::Index>(i));
    column.segment(k, 3) = (coordinate_weight * rotation * x).cast<float>();
    column.tail(3) = (normal_weight * rotation * normal).cast<float>();
  }
}

/// Matches by the map so far, by rotated smooth coordinates and by rotated normals.
VertexMatches match_rotated(const ShapePairSpectra& pair, const MapCandidate& candidate, const Mat<3>& rotation) {
  const Eigen::MatrixXd& c = candidate.c;
  Embedding embedding;
  if (c.rows() > 0) embedding = spectral_embedding(pair, pair.coarsest, c, 0);
  append_tips(candidate, pair.coarsest, embedding);
  const Mat<3> rotations[2] = {rotation, Mat<3>::Identity()};
  for (int s = 0; s < 2; ++s)
    append_rotated(*pair.shapes[s], pair.smoothed[s].with(std::min(n_smooth, pair.n_functions)).coordinates,
                   pair.coarsest[s], rotations[s], embedding.on[s]);
  return match_vertices(pair.coarsest, embedding, pair.landmarks.size() + n_queries);
}

template <class Key>
void sort_by(std::vector<MapCandidate>& candidates, const Key& key) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const MapCandidate& a, const MapCandidate& b) { return key(a) < key(b); });
}

/// The first map that landmarks suggest.
void start_by_landmarks(const ShapePairSpectra& pair, MapCandidate& candidate) {
  for (const auto& [p, q] : pair.landmarks) {
    candidate.matches.from[0].push_back(p);
    candidate.matches.to[0].push_back(q);
  }
  const int k = std::clamp(static_cast<int>(pair.landmarks.size() / 2), 2, n_merged);
  candidate.c = orthogonal_map(pair, candidate.matches, k);
  upsample(pair, {k, n_merged}, 0, candidate);
}

/// A map on more functions, and its score.
void refine_coarsely(const ShapePairSpectra& pair, const std::vector<int>& steps, MapCandidate& candidate) {
  upsample(pair, steps, embedded_normal_weight, candidate);
  candidate.coarse_score = score_map(pair, candidate.matches, candidate.c);
}

/// From a first map on n_merged functions to one on few more, with the rotated surfaces, and its score.
void refine_rotated(const ShapePairSpectra& pair, const Mat<3>& rotation, MapCandidate& candidate) {
  candidate.matches = match_rotated(pair, candidate, rotation);
  candidate.c.resize(0, 0);
  refine_coarsely(pair, first_steps, candidate);
}

/// The first map that ends of limbs suggest.
void start_by_tips(const ShapePairSpectra& pair, const TipAssignment& tips, MapCandidate& candidate) {
  Embedding embedding;
  for (int s = 0; s < 2; ++s) candidate.tips[s] = tip_features(*pair.shapes[s], tips, s);
  append_tips(candidate, pair.coarsest, embedding);
  candidate.matches = match_vertices(pair.coarsest, embedding, pair.landmarks.size() + n_queries);
  upsample(pair, {n_merged}, 0, candidate);
}

/// The first map that the surfaces suggest after a rotation, by their smoothed coordinates alone.
void start_rotated(const ShapePairSpectra& pair, const Mat<3>& rotation, MapCandidate& candidate) {
  candidate.matches = match_rotated(pair, candidate, rotation);
  upsample(pair, {n_merged}, 0, candidate);
}

/// The weights of landmarks, at most `trust` all together; the less, the farther one is from where the map takes it in
/// comparison with others.
std::vector<double> landmark_weights(const ShapePairSpectra& pair, const VertexMatches& matches, double trust) {
  if (trust == 0 || pair.landmarks.empty()) return {};
  std::vector<double> weights = landmark_distances(pair, matches);
  const double scale = std::max(least_landmark_scale, 2 * quantile(weights, 0.5)),
               n = static_cast<double>(weights.size());
  for (double& w : weights) w = trust / (n * (1 + w * w / (scale * scale)));
  return weights;
}

/// From a map on n_scored functions to one on all functions. Least squares allow what orthogonal maps do not, and begin
/// with fewer functions again to make use of it. Few functions need few samples.
void refine_densely(const ShapePairSpectra& pair, double trust_in_landmarks, MapCandidate& candidate) {
  std::vector<int> steps = {24, 32, n_scored};
  for (int step = 1; step <= 8; ++step) steps.push_back(n_scored + (pair.n_functions - n_scored) * step / 8);
  for (const int k : steps) {
    candidate.c =
        functional_map(pair, candidate.matches, k, landmark_weights(pair, candidate.matches, trust_in_landmarks));
    Embedding embedding = spectral_embedding(pair, pair.dense, candidate.c, embedded_normal_weight,
                                             local_weight(pair, candidate.matches, candidate.c));
    append_tips(candidate, pair.dense, embedding);
    const std::size_t n_samples = k <= n_scored ? n_refined_queries / 2 : n_refined_queries;
    candidate.matches = match_vertices(pair.dense, embedding, pair.landmarks.size() + n_samples);
  }
}

/// How far the search is, in hundredths of the time that its stages take.
class SearchProgress {
 public:
  /// Calls body(i) for the candidates of one stage, at whose end `end` of the search are done.
  void stage(std::size_t end, std::size_t n, const auto& body) {
    std::atomic<std::size_t> n_done = 0;
    parallel_for(
        n,
        [&](std::size_t i) {
          body(i);
          activity_.done(begin_ + (end - begin_) * ++n_done / n);
        },
        1);
    begin_ = end;
  }

 private:
  Activity activity_{"comparing maps", 100};
  std::size_t begin_ = 0;
};

/// The candidates from the n-th on, which are taken out.
std::vector<MapCandidate> taken_from(std::vector<MapCandidate>& candidates, std::size_t n) {
  const auto first = candidates.begin() + static_cast<std::ptrdiff_t>(n);
  std::vector<MapCandidate> taken(std::make_move_iterator(first), std::make_move_iterator(candidates.end()));
  candidates.resize(n);
  return taken;
}

/// The n best distinct ones by their coarse scores and ends of limbs, that of the surfaces as they lie, which callers
/// judge by more than its score, and of the others the n best by what tells maps apart in the end. \return the number
/// of those before the others
std::size_t choose_best(const ShapePairSpectra& pair, std::vector<MapCandidate>& candidates, int n) {
  // Maps that differ at the end of one limb count as one: that one stays whose ends are where they belong.
  sort_by(candidates, [](const MapCandidate& c) {
    return tip_factor(c.coarse_score.tips) * c.coarse_score.total() + c.coarse_score.landmarks;
  });
  candidates = distinct(pair, std::move(candidates));
  const auto n_by_score = std::min(static_cast<std::size_t>(n), candidates.size());
  std::vector<MapCandidate> others = taken_from(candidates, n_by_score);
  sort_by(others, [](const MapCandidate& c) { return c.is_identity ? -1 : c.coarse_score.distinction(); });
  const bool has_identity = !others.empty() && others[0].is_identity;
  others.resize(std::min(others.size(), static_cast<std::size_t>(n) + has_identity));
  std::ranges::move(others, std::back_inserter(candidates));
  return n_by_score + has_identity;
}

/// Whether the first, ascending by their order, is nearly isometric and clearly better than all others.
bool is_sure(const std::vector<MapCandidate>& candidates) {
  return error_growth(candidates[0].total()) == 1 &&
         (candidates.size() == 1 || candidates[1].order() > clear_margin * candidates[0].order());
}

/// What coarse scores leave, and what is refined, too, where they leave doubt.
struct CoarseMaps {
  std::vector<MapCandidate> candidates, others;
  double mirrored_gain;  ///< as in FoundMaps
};

CoarseMaps coarse_maps(const ShapePairSpectra& pair, const AlignmentOptions& options, SearchProgress& progress) {
  if (pair.n_functions < n_scored)
    throw_input_error("maps are compared by {} eigenfunctions, of which there are {}", n_scored, pair.n_functions);
  std::vector<Eigen::MatrixXd> starts;
  if (!are_ambiguous(*pair.shapes[0], *pair.shapes[1]))
    starts = start_maps(pair.shapes[0]->values, pair.shapes[1]->values, options.start_functions, options.swap_ratio);
  std::vector<TipAssignment> tips;
  if (!starts.empty()) tips = assign_tips(pair.shapes[0]->tips, pair.shapes[1]->tips, n_tip_starts);
  const bool by_landmarks = !pair.landmarks.empty();
  std::vector<MapCandidate> candidates(1 + starts.size() + tips.size() + by_landmarks);
  candidates.back().is_by_landmarks = by_landmarks;
  candidates[0].is_identity = true;
  progress.stage(14, candidates.size(), [&](std::size_t i) {
    MapCandidate& candidate = candidates[i];
    if (candidate.is_identity) return start_rotated(pair, Mat<3>::Identity(), candidate);
    if (candidate.is_by_landmarks) return start_by_landmarks(pair, candidate);
    if (i > starts.size()) return start_by_tips(pair, tips[i - 1 - starts.size()], candidate);
    candidate.c = starts[i - 1];
    std::vector<int> steps;
    for (int k = static_cast<int>(candidate.c.rows()); k <= n_merged; ++k) steps.push_back(k);
    upsample(pair, steps, 0, candidate);
  });
  candidates = distinct(pair, std::move(candidates));
  const int n_smoothed = std::min(n_smooth, pair.n_functions);
  const double gain = mirrored_gain(pair, candidates);
  progress.stage(50, candidates.size(), [&](std::size_t i) {
    MapCandidate& candidate = candidates[i];
    refine_rotated(
        pair, candidate.is_identity ? Mat<3>(Mat<3>::Identity()) : proper_rotation(pair, candidate.matches, n_smoothed),
        candidate);
  });
  choose_best(pair, candidates, std::max(n_promising, options.refined));
  progress.stage(56, candidates.size(), [&](std::size_t i) { refine_coarsely(pair, last_steps, candidates[i]); });
  choose_best(pair, candidates, options.refined);
  // What the surfaces suggest as they lie is often better than what any signs of eigenfunctions lead to. Turned
  // surfaces suggest the same once they are turned back.
  const std::size_t n_first = candidates.size();
  candidates.resize(2 * n_first);
  progress.stage(58, n_first, [&](std::size_t i) {
    const Mat<3> rotation = proper_rotation(pair, candidates[i].matches, n_smoothed);
    start_rotated(pair, rotation, candidates[n_first + i]);
    refine_rotated(pair, rotation, candidates[n_first + i]);
    refine_coarsely(pair, last_steps, candidates[n_first + i]);
  });
  std::vector<MapCandidate> others = taken_from(candidates, choose_best(pair, candidates, options.refined));
  return {std::move(candidates), std::move(others), gain};
}

/// All that are refined, ascending by their order.
std::vector<MapCandidate> refined_maps(const ShapePairSpectra& pair, CoarseMaps coarse, SearchProgress& progress) {
  auto& candidates = coarse.candidates;
  auto& others = coarse.others;
  const auto refine_all = [&](std::size_t end, std::vector<MapCandidate>& all) {
    progress.stage(end, all.size(), [&](std::size_t i) {
      refine_densely(pair, 0, all[i]);
      all[i].score = score_map(pair, all[i].matches, all[i].c);
    });
  };
  refine_all(70, candidates);
  sort_by(candidates, [](const MapCandidate& c) { return c.order(); });
  if (!is_sure(candidates)) {
    refine_all(80, others);
    std::ranges::move(others, std::back_inserter(candidates));
  }
  // Of nearly equal ones the more isometric is better; they say nothing about how clear the choice is.
  sort_by(candidates, [](const MapCandidate& c) { return c.order() * c.total(); });
  candidates = distinct(pair, std::move(candidates));
  sort_by(candidates, [](const MapCandidate& c) { return c.order(); });
  return candidates;
}

/// The matches of `one` where those of `other` are elsewhere, farther than 0.1 roots of the area.
VertexMatches matches_apart(const ShapePairSpectra& pair, const VertexMatches& one, const VertexMatches& other) {
  constexpr double apart = 0.1;
  VertexMatches chosen;
  for (int s = 0; s < 2; ++s) {
    const auto& vertices = pair.shapes[1 - s]->surface.vertices;
    for (std::size_t i = 0; i < one.to[s].size(); ++i) {
      if ((vertices[one.to[s][i]] - vertices[other.to[s][i]]).norm() <= apart) continue;
      chosen.from[s].push_back(one.from[s][i]);
      chosen.to[s].push_back(one.to[s][i]);
    }
  }
  return chosen;
}

}  // namespace

double margin_between(const ShapePairSpectra& pair, const MapCandidate& first, const MapCandidate& other) {
  const double overall = other.order() / first.order();
  const VertexMatches of_first = matches_apart(pair, first.matches, other.matches),
                      of_other = matches_apart(pair, other.matches, first.matches);
  if (of_first.from[0].empty() && of_first.from[1].empty()) return overall;
  const auto order = [&](const MapCandidate& map, const VertexMatches& apart) {
    return map.order_of(score_samples(pair, apart, map.c));
  };
  return std::sqrt(overall * order(other, of_other) / order(first, of_first));
}

bool are_ambiguous(const SpectralShape& a, const SpectralShape& b) {
  return has_no_axes(a.values) || has_no_axes(b.values);
}

std::optional<MapCandidate> best_map_within(const ShapePairSpectra& pair, const AlignmentOptions& options,
                                            double most) {
  // Refinement has changed what tells maps apart by factors of 0.85 to 1.6.
  constexpr double most_gain = 2;
  SearchProgress progress;
  CoarseMaps coarse = coarse_maps(pair, options, progress);
  const auto may_be = [&](const MapCandidate& c) { return c.coarse_score.distinction() < most_gain * most; };
  if (std::ranges::none_of(coarse.candidates, may_be) && std::ranges::none_of(coarse.others, may_be))
    return std::nullopt;
  return refined_maps(pair, std::move(coarse), progress).front();
}

FoundMaps search_maps(const ShapePairSpectra& pair, const AlignmentOptions& options) {
  SearchProgress progress;
  CoarseMaps coarse = coarse_maps(pair, options, progress);
  const double mirrored_gain = coarse.mirrored_gain;
  std::vector<MapCandidate> candidates = refined_maps(pair, std::move(coarse), progress);
  // Scores, whose limits are known, are those of maps without landmarks. How exact landmarks are, the best map tells.
  // A second refinement begins with the exact map of the first, so that few functions and spin images turn small parts,
  // such as heads, that the first left turned; others than eligible maps only landmarks make first.
  const bool by_landmarks = !pair.landmarks.empty();
  const double trust = by_landmarks ? landmark_trust(candidates[0].total(), candidates[0].score.landmark_noise) : 0;
  const double most = eligible_order * candidates[0].order();
  progress.stage(100, candidates.size(), [&](std::size_t i) {
    if (by_landmarks) candidates[i].landmark_trust = trust;
    if (by_landmarks || candidates[i].order() <= most) refine_densely(pair, trust, candidates[i]);
  });
  return {distinct(pair, std::move(candidates)), mirrored_gain};
}

}  // namespace shellmatch
