#include "matching/alignment/search_starts.h"

#include "alignment/outline/find_outline_pairs.h"
#include "alignment/pairs/find_pairs.h"
#include "alignment/rigid/find_rigid_pairs.h"
#include "matching/alignment/choose_pose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// Pairs of outlines are off by 0.010 to 0.023 diagonals (docs/alignment.md).
constexpr double outline_spread = 2;

// So many landmarks halve what pairs err by beyond those of isometric shapes.
constexpr double halving_landmarks = 10;

double spread_at(double score, double n_landmarks) {
  return 1 + (error_growth(score) - 1) / (1 + n_landmarks / halving_landmarks);
}

template <int Dim>
std::vector<Landmark<Dim>> as_landmarks(const std::vector<CorrespondingPointsIn<Dim>>& pairs) {
  std::vector<Landmark<Dim>> landmarks;
  for (const auto& pair : pairs)
    landmarks.push_back({fmt::format("pair {}", landmarks.size() + 1), pair.on_reference, pair.on_template, pair.weight});
  return landmarks;
}

template <int Dim>
Start<Dim> start_of(const auto& candidate, double spread, const AlignOptions& options, bool with_pairs) {
  Start<Dim> start;
  start.n_pairs = candidate.pairs.size();
  start.score = std::max(0.0, candidate.score);  // rounding
  start.is_identity = candidate.is_identity && !candidate.is_mirrored;
  start.is_mirrored = candidate.is_mirrored;
  if (!start.is_usable()) return start;
  start.alignment.pose = choose_pose<Dim>(candidate.pairs, options, candidate.is_mirrored ? Mirroring::always : Mirroring::never);
  start.alignment.spread = spread;
  if (with_pairs && options.weight > 0) start.alignment.pairs = as_landmarks<Dim>(candidate.pairs);
  return start;
}

}  // namespace

StartSearch<3> search_starts(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks, const AlignOptions& options) {
  std::vector<CorrespondingPoints> known;
  for (const Landmark<3>& l : landmarks) known.push_back({l.on_reference, l.on_template, 1});
  const AutomaticPairs found = find_pairs(shapes.reference.surface, shapes.template_shape.surface, options.search, known);
  StartSearch<3> search{{}, found.margin};
  for (const PairCandidate& candidate : found.candidates) {
    const double n_telling = candidate.landmark_distance ? candidate.landmark_trust * static_cast<double>(landmarks.size()) : 0;
    search.starts.push_back(start_of<3>(candidate, spread_at(candidate.score, n_telling), options, true));
    search.starts.back().landmark_distance = candidate.landmark_distance;
    if (candidate.landmark_distance) search.starts.back().alignment.landmark_trust = candidate.landmark_trust;
  }
  return search;
}

StartSearch<2> search_starts(const ShapePair<2>& shapes, const std::vector<Landmark<2>>&, const AlignOptions& options) {
  const OutlinePairs found = find_outline_pairs(shapes.reference.surface, shapes.template_shape.surface, options.search);
  StartSearch<2> search{{}, found.margin};
  for (const OutlineCandidate& candidate : found.candidates) {
    // What differs from the first by a symmetry of the template is as good as the first, which turns least.
    if (candidate.is_symmetry) continue;
    search.starts.push_back(start_of<2>(candidate, outline_spread, options, true));
  }
  return search;
}

StartSearch<3> search_poses(const ShapePair<3>& shapes, const AlignOptions& options) {
  const RigidPairs found = find_rigid_pairs(shapes.reference.surface, shapes.template_shape.surface, options.search);
  return {{start_of<3>(found.candidates.front(), 1, options, false)}, found.margin};
}

}  // namespace shellmatch
