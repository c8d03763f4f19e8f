#pragma once
/// \file
/// What two shapes have in common where one is a part of the other, as far as pairs of points tell.

#include "energies/pairs/point_pairs.h"
#include "matching/level/observed_mask.h"

#include <vector>

namespace shellmatch {

/// What both shapes have data of, but of the whole only what lies about as near points with a partner as points of the
/// part do: the rest has no place in the part, whose edges would pull it. The whole is the shape of which more is
/// there, by area, as in the search. \param observed observed_pair(deformed, other) \param deformed, other in the unit
/// domain; phi deforms the first \param sets of which `alignment` has pairs; without it all of the whole counts
template <int Dim>
ObservedPair<Dim> paired_parts(ObservedPair<Dim> observed, const Shape<Dim>& deformed, const Shape<Dim>& other,
                               const std::vector<PairSet<Dim>>& sets);

}  // namespace shellmatch
