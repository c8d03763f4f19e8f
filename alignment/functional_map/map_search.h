#pragma once
/// \file
/// Search for the map between two surfaces: starts, rotations, upsampling, choice.

#include "alignment/functional_map/map_candidate.h"

#include <optional>
#include <vector>

namespace shellmatch {

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

/// Above this mirrored_gain the mirror image is worth a search of its own, and tells where it is better by this factor
/// in the end, too: shapes with two like sides have gains of 0.9 to 1.05, those of one side 0.1 to 0.7, and of two
/// sides 1.1 to 6.5 between individuals.
inline constexpr double telling_gain = 1.5;

/// The best maps. Landmarks suggest a start of their own, and once scores are known, which are those of maps without
/// them, eligible maps are refined again with landmarks among the pairs. Where spectra are_ambiguous(), only the
/// surfaces as they lie and landmarks give starts.
FoundMaps search_maps(const ShapePairSpectra& pair, const AlignmentOptions& options);

/// The best map without landmarks; none, in half the time, where coarse scores already tell that its order() is not
/// below `most`.
std::optional<MapCandidate> best_map_within(const ShapePairSpectra& pair, const AlignmentOptions& options, double most);

}  // namespace shellmatch
