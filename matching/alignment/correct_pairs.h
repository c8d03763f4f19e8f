#pragma once
/// \file
/// Pairs that were found, made more exact by landmarks.

#include "energies/pairs/point_pairs.h"
#include "geometry/distance/signed_distance.h"

#include <vector>

namespace shellmatch {

/// Pairs of shapes far from isometric have errors that neighbours share, such as all pairs of an arm too far along it.
/// The nearest pairs of a landmark tell their error there; pairs around it, on both shapes, are corrected by as much,
/// and projected onto the template. Landmarks more than a tenth of the template's diagonal away from where the pairs
/// map them are ignored: either they or the pairs are wrong. \param pairs, landmarks in the unit domain \param share of
/// the error that is corrected, 0 to 1
template <int Dim>
void correct_pairs(std::vector<PointPair<Dim>>& pairs, const std::vector<PointPair<Dim>>& landmarks, double share,
                   const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape);

}  // namespace shellmatch
