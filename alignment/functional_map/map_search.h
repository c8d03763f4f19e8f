#pragma once
/// \file
/// Search for the map between two surfaces: starts, rotations, upsampling, choice.

#include "alignment/functional_map/map_score.h"

#include <algorithm>
#include <optional>

namespace shellmatch {

/// A map with its score.
struct MapCandidate {
  Eigen::MatrixXd c;      ///< functional map
  VertexMatches matches;  ///< of samples
  MapScore coarse_score;  ///< at 40 eigenfunctions
  MapScore score;         ///< at all, before the landmarks were among the pairs

  double landmark_trust =
      1;  ///< landmark_trust() of the best map: the factor on the landmarks' weights in the last refinement of all

  Features tips[2];  ///< rows that hold a map that began with tips near them, a column for each vertex; none of others

  bool is_identity = false;      ///< began with the surfaces as they lie
  bool is_by_landmarks = false;  ///< began with landmarks

  double total() const { return 0.5 * (coarse_score.total() + score.total()); }
  /// The lower, the better: what tells maps apart, beyond the noise of sampling, and the more, the farther landmarks
  /// are.
  double order() const { return order_of(score); }
  /// The same with what tells maps apart on some samples alone.
  double order_of(const MapScore& of_samples) const {
    return (1e-3 + of_samples.distinction()) * (1 + score.landmarks / std::max(total(), 0.1));
  }
};

/// Callers choose among maps whose order() is at most this many times the least, without landmarks: others need no
/// second refinement and no pairs.
inline constexpr double eligible_order = 1.2;

/// By which factor `other` is worse than `first`: the geometric mean of the ratio of their orders over all samples and
/// of that over the samples whose images differ by more than 0.1 roots of the area. Maps that differ by one limb agree
/// elsewhere, which hides in the former how much worse one of them is. \pre both have the same samples
double margin_between(const ShapePairSpectra& pair, const MapCandidate& first, const MapCandidate& other);

/// Whether spectra leave open by which rotation the surfaces correspond: has_no_axes() of either.
bool are_ambiguous(const SpectralShape& a, const SpectralShape& b);

struct FoundMaps {
  std::vector<MapCandidate> maps;  ///< at least one, distinct, ascending by their order()
  /// By which factor the best of the first maps that turn surface 1 inside out is better than the best of the others:
  /// well above 1 where one surface is of the other side, as a left hand beside a right one; about 1 for surfaces with
  /// two like sides.
  double mirrored_gain = 0;
};

/// The best maps. Landmarks suggest a start of their own, and once scores are
/// known, which are those of maps without them, eligible maps are refined again with landmarks among the pairs. Where
/// spectra are_ambiguous(), only the surfaces as they lie and landmarks give starts.
FoundMaps search_maps(const ShapePairSpectra& pair, const AlignmentOptions& options);

/// The best map without landmarks; none, in half the time, where coarse scores already tell that its order() is not
/// below `most`.
std::optional<MapCandidate> best_map_within(const ShapePairSpectra& pair, const AlignmentOptions& options, double most);

}  // namespace shellmatch
