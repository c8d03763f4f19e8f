#pragma once
/// \file
/// Pairs that were found, made more exact by landmarks.

#include "energies/pairs/point_pairs.h"
#include "geometry/distance/signed_distance.h"

#include <vector>

namespace shellmatch {

/// Pairs of shapes far from isometric err systematically: all of an arm lie too far along it. What they err by at a landmark is told
/// by its nearest pairs, and its neighbours are moved by as much, back on the template. A landmark that is more than a tenth of the
/// template's diagonal from where the pairs have it changes none: they are wrong there altogether, or it is.
/// \param pairs, landmarks in the unit domain
/// \param share of the difference that the pairs are moved by, 0 to 1
template <int Dim>
void correct_pairs(std::vector<PointPair<Dim>>& pairs, const std::vector<PointPair<Dim>>& landmarks, double share,
                   const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape);

}  // namespace shellmatch
