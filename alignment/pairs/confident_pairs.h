#pragma once
/// \file
/// Pairs of points out of a dense map, without doubtful ones and without those that contradict most of the pairs beside
/// them.

#include "alignment/functional_map/map_search.h"
#include "alignment/pairs/corresponding_points.h"
#include "base/types.h"

#include <utility>
#include <vector>

namespace shellmatch {

/// Neighbours on surface 1 by which a pair is judged. Along the surface: what touches it, as a hand on another arm, may
/// move apart.
inline constexpr std::size_t n_near = 6;

/// A map that is right elsewhere may take a patch of a limb to another limb, there and back, so that neither cycles nor
/// most neighbours tell. Each point is joined with those near it where the map takes both, of which either may be
/// `error` from where it belongs, to no more than max_stretch times their distance; of points that are connected when
/// the map is not asked, only the largest group that is joined is consistent. \param nearest of each point
/// (nearest_along()) \param to where the map takes each \return for each point, whether it belongs to such a group
std::vector<bool> in_consistent_group(const NeighbourLists& nearest, const std::vector<Vec<3>>& to, double max_stretch,
                                      double error);

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
