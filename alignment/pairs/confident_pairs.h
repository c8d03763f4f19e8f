#pragma once
/// \file
/// Pairs of points out of a dense map, with doubtful ones left out.

#include "alignment/functional_map/map_search.h"
#include "alignment/pairs/corresponding_points.h"

namespace shellmatch {

struct ConfidentPairs {
  std::vector<CorrespondingPoints> pairs;
  /// Others that pass alone, in patches which contradict most pairs around them (in_consistent_group()): such a map is
  /// wrong there.
  std::vector<CorrespondingPoints> contradicting;
  std::vector<Index> map;  ///< the image of every vertex of surface 1, in their order
};

/// Farthest point samples of surface 1, which are vertices, and their images anywhere on the facets of surface 2, where
/// the way there and back closes within options.cycle_tolerance and the map stretches the surroundings by at most
/// options.max_stretch or its inverse. The weight falls from 1 where the cycle closes exactly to 0 at the tolerance.
/// Cycles and stretches find local errors; a map that is wrong as a whole passes. \return pairs in the coordinates of
/// SpectralShape
ConfidentPairs confident_pairs(const ShapePairSpectra& pair, const MapCandidate& candidate,
                               const AlignmentOptions& options);

}  // namespace shellmatch
