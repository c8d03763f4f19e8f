#pragma once
/// \file
/// Pairs of points that contradict most of the pairs beside them.

#include "base/types.h"

#include <utility>
#include <vector>

namespace shellmatch {

/// Indices of the n_neighbours points nearest to each point and their distances, in rising order; of fewer points, all
/// others.
std::vector<std::vector<std::pair<double, std::size_t>>> nearest_neighbours(const std::vector<Vec<3>>& points,
                                                                            std::size_t n_neighbours);

/// A map that is right elsewhere may take a patch of a limb to another limb, there and back, so that neither cycles nor
/// most neighbours tell. Each point is joined with its nearest six where the map takes both, of which either may be
/// `error` from where it belongs, to no more than max_stretch times their distance; of points that are connected when
/// the map is not asked, only the largest group that is joined is consistent. \param from, to  points, and where a map
/// takes each \return for each point, whether it belongs to such a group
std::vector<bool> in_consistent_group(const std::vector<Vec<3>>& from, const std::vector<Vec<3>>& to,
                                      double max_stretch, double error);

}  // namespace shellmatch
