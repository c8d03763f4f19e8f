#include "matching/alignment/search_starts.h"

#include "alignment/functional_map/map_search.h"
#include "alignment/functional_map/two_way_map.h"
#include "alignment/outline/find_outline_pairs.h"
#include "alignment/pairs/find_pairs.h"
#include "alignment/partial/find_partial_pairs.h"
#include "alignment/rigid/find_rigid_pairs.h"
#include "base/error.h"
#include "geometry/distance/buried_parts.h"
#include "matching/alignment/choose_pose.h"
#include "matching/level/observed_mask.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

// Pairs of outlines are off by 0.010 to 0.023 diagonals (docs/alignment.md).
constexpr double outline_spread = 2;

// How much better the mirrored reference has to fit before the run speaks of it, where first maps do not tell.
constexpr double far_better = 3;

// So many landmarks halve the part of the pairs' errors that exceeds those of nearly isometric shapes.
constexpr double halving_landmarks = 10;

double spread_at(double score, double n_landmarks) {
  return 1 + (error_growth(score) - 1) / (1 + n_landmarks / halving_landmarks);
}

template <int Dim>
std::vector<Landmark<Dim>> as_landmarks(const std::vector<CorrespondingPointsIn<Dim>>& pairs) {
  std::vector<Landmark<Dim>> landmarks;
  for (const auto& pair : pairs)
    landmarks.push_back({pair_name(landmarks.size()), pair.on_reference, pair.on_template, pair.weight});
  return landmarks;
}

std::vector<CorrespondingPoints> points_of(const std::vector<Landmark<3>>& landmarks) {
  std::vector<CorrespondingPoints> points;
  for (const Landmark<3>& l : landmarks) points.push_back({l.on_reference, l.on_template, 1});
  return points;
}

// Mean square distance of points from their mean.
template <class Points, class Position>
double variance(const Points& points, const Position& position) {
  Vec<3> mean = Vec<3>::Zero();
  for (const auto& p : points) mean += position(p) / static_cast<double>(points.size());
  double sum = 0;
  for (const auto& p : points) sum += (position(p) - mean).squaredNorm();
  return sum / static_cast<double>(points.size());
}

// Landmarks on a head alone say little about the legs. Drawn at random from all of a shape, four have half of its
// variance or more in nine cases of ten.
bool are_spread(const std::vector<Landmark<3>>& landmarks, const Surface<3>& surface) {
  constexpr double least_share = 0.25;
  if (landmarks.empty()) return false;
  const double of_landmarks = variance(landmarks, [](const Landmark<3>& l) { return l.on_template; });
  return of_landmarks >= least_share * variance(surface.vertices, [](const Vec<3>& x) { return x; });
}

/// Gives a start its pose. Pairs that a wrong map has brought together on a line are as good as none.
template <int Dim>
void set_pose(Start<Dim>& start, const std::vector<CorrespondingPointsIn<Dim>>& pairs, const AlignOptions& options,
              Mirroring mirroring) {
  if (!start.is_usable()) return;
  try {
    start.alignment.pose = choose_pose<Dim>(pairs, options, mirroring);
  } catch (const InputError&) {
    start.n_pairs = 0;
  }
}

template <int Dim>
Start<Dim> start_of(const auto& candidate, double spread, const AlignOptions& options, bool with_pairs) {
  Start<Dim> start;
  start.n_pairs = candidate.pairs.size();
  start.score = std::max(0.0, candidate.score);  // rounding
  start.is_identity = candidate.is_identity && !candidate.is_mirrored;
  start.is_mirrored = candidate.is_mirrored;
  set_pose(start, candidate.pairs, options, candidate.is_mirrored ? Mirroring::always : Mirroring::never);
  if (!start.is_usable()) return start;
  start.alignment.spread = spread;
  if (!with_pairs || !(options.weight > 0)) return start;
  std::vector<CorrespondingPointsIn<Dim>> pairs = candidate.pairs;
  if constexpr (requires { candidate.contradicting; }) {
    start.n_contradicting = candidate.contradicting.size();
    pairs.insert(pairs.end(), candidate.contradicting.begin(), candidate.contradicting.end());
  }
  start.alignment.pairs = as_landmarks<Dim>(pairs);
  return start;
}

/// What the file has, or with nothing made up all that encloses the shape. Distances along a surface know nothing of
/// what lies inside other parts, and every border that is no border of the part misleads.
Surface<3> measured(const Shape<3>& shape) {
  if (shape.invented_share == 0) return shape.surface;
  return shape.buried_share > 0 ? with_buried(shape.evidence) : shape.evidence.observed;
}

/// Whether the first is the part: a shape with gaps is one of a shape without any, and of two with gaps the smaller
/// one.
bool is_part_of(const Shape<3>& one, const Surface<3>& of_one, const Shape<3>& other, const Surface<3>& of_other) {
  const auto is_complete = [](const Shape<3>& shape) { return shape.invented_share <= least_of_cut; };
  if (is_complete(one) != is_complete(other)) return is_complete(other);
  return surface_measure(of_one) <= surface_measure(of_other);
}

double share_of_samples(std::size_t n_pairs, const PreparedSurface& sampled, const AlignmentOptions& options) {
  const std::size_t n_samples = std::min(static_cast<std::size_t>(options.pairs), sampled.surface.vertices.size());
  return static_cast<double>(n_pairs) / static_cast<double>(n_samples);
}

}  // namespace

StartSearch<3> search_partial_starts(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks,
                                     const AlignOptions& options) {
  const Surface<3> reference = measured(shapes.reference), template_surface = measured(shapes.template_shape);
  const bool reference_is_part = is_part_of(shapes.reference, reference, shapes.template_shape, template_surface);
  const auto exchange = [&](std::vector<CorrespondingPoints>& pairs) {
    if (!reference_is_part)
      for (CorrespondingPoints& pair : pairs) std::swap(pair.on_reference, pair.on_template);
  };
  std::vector<CorrespondingPoints> known = points_of(landmarks);
  exchange(known);
  PartialPairs found = reference_is_part ? find_partial_pairs(reference, template_surface, options.search, known)
                                         : find_partial_pairs(template_surface, reference, options.search, known);
  const bool landmarks_tell = found.candidates.front().landmark_distance.has_value();
  StartSearch<3> search{{},
                        found.margin,
                        landmarks_tell && are_spread(landmarks, shapes.template_shape.surface),
                        landmarks_tell ? landmarks.size() : 0};
  search.is_of_part = true;
  const Shape<3>& part = reference_is_part ? shapes.reference : shapes.template_shape;
  search.notes.push_back(fmt::format("{} is searched as a part of the other shape, without what was made up{}",
                                     part.source,
                                     found.scale == 1 ? "" : fmt::format(", and scaled by {:.3g}", found.scale)));
  for (PartialCandidate& candidate : found.candidates) {
    exchange(candidate.pairs);
    Start<3>& start = search.starts.emplace_back();
    start.n_pairs = candidate.pairs.size();
    start.pair_share = share_of_samples(start.n_pairs, found.part, options.search);
    start.score = candidate.score;
    start.order = candidate.order;
    start.landmark_distance = candidate.landmark_distance;
    set_pose(start, candidate.pairs, options, Mirroring::never);
    if (!start.is_usable()) continue;
    start.alignment.is_of_part = true;
    start.alignment.spread = spread_at(candidate.score, 0);
    if (options.weight > 0) start.alignment.pairs = as_landmarks<3>(candidate.pairs);
  }
  return search;
}

StartSearch<3> search_whole_starts(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks,
                                   const AlignOptions& options) {
  const std::vector<CorrespondingPoints> known = points_of(landmarks);
  AutomaticPairs found = find_pairs(shapes.reference.surface, shapes.template_shape.surface, options.search, known);
  StartSearch<3> search{
      {}, found.margin, are_spread(landmarks, shapes.template_shape.surface), found.candidates.front().n_landmarks};
  search.is_ambiguous = found.is_ambiguous;
  search.mirrored_gain = found.mirrored_gain;
  // Of symmetric shapes both are alike; the mirrored copy of a bone differs from its other side by a tenth of what a
  // wrong one does.
  search.fits_far_better_mirrored = [reference = found.spectra[0], template_shape = found.spectra[1],
                                     better = found.mirrored_gain > telling_gain ? telling_gain : far_better,
                                     options](const Start<3>& start) {
    return fits_mirrored(*reference, *template_shape, options.search, options.doubtful_score, start.order / better);
  };
  search.reference_share = found.reference.share;
  search.template_share = found.template_surface.share;
  for (const auto& [shape, prepared] :
       {std::pair(&shapes.reference, &found.reference), std::pair(&shapes.template_shape, &found.template_surface)})
    if (prepared->share < 1)
      search.notes.push_back(fmt::format("pairs are of the {} component of {} alone, {:.0f} % of its area",
                                         prepared->rank == 0 ? "largest" : "most alike", shape->source,
                                         100 * prepared->share));
  std::optional<ObservedPair<3>> observed;  // takes time, and is rarely asked
  if (shapes.one_is_part()) observed = observed_pair(shapes.reference, shapes.template_shape);
  for (PairCandidate& candidate : found.candidates) {
    const double pair_share = share_of_samples(candidate.pairs.size(), found.reference, options.search);
    if (observed)
      for (auto* pairs : {&candidate.pairs, &candidate.contradicting})
        std::erase_if(*pairs,
                      [&](const CorrespondingPoints& p) { return !observed->contains(p.on_reference, p.on_template); });
    const double n_telling =
        candidate.landmark_distance ? candidate.landmark_trust * static_cast<double>(candidate.n_landmarks) : 0;
    search.starts.push_back(start_of<3>(candidate, spread_at(candidate.score, n_telling), options, true));
    search.starts.back().landmark_distance = candidate.landmark_distance;
    search.starts.back().order = candidate.order;
    search.starts.back().margin = candidate.margin;
    search.starts.back().pair_share = pair_share;
    if (candidate.landmark_distance) search.starts.back().alignment.landmark_trust = candidate.landmark_trust;
  }
  return search;
}

StartSearch<3> search_starts(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks,
                             const AlignOptions& options) {
  return (shapes.one_is_part() ? search_partial_starts : search_whole_starts)(shapes, landmarks, options);
}

StartSearch<2> search_starts(const ShapePair<2>& shapes, const std::vector<Landmark<2>>&, const AlignOptions& options) {
  const OutlinePairs found =
      find_outline_pairs(shapes.reference.surface, shapes.template_shape.surface, options.search);
  StartSearch<2> search{{}, found.margin};
  for (const OutlineCandidate& candidate : found.candidates) {
    // What differs from the first by a symmetry of the template is as good as the first, which turns least.
    if (candidate.is_symmetry) continue;
    search.starts.push_back(start_of<2>(candidate, outline_spread, options, true));
  }
  return search;
}

StartSearch<3> search_poses(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks,
                            const AlignOptions& options) {
  const Surface<3>& template_surface = shapes.template_shape.surface;
  const RigidPairs found = find_rigid_pairs(shapes.reference.surface, template_surface, options.search);
  StartSearch<3> search{{start_of<3>(found.candidates.front(), 1, options, false)},
                        found.margin,
                        are_spread(landmarks, template_surface)};
  if (landmarks.size() >= n_least_landmarks) {
    search.n_landmarks = landmarks.size();
    Start<3>& start = search.starts.front();
    start.landmark_distance =
        median_distance(points_of(landmarks), start.alignment.pose) / std::sqrt(surface_measure(template_surface));
  }
  return search;
}

}  // namespace shellmatch
