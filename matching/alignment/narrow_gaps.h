#pragma once
/// \file
/// Where parts of a shape lie close to each other: a deformation that is to move them apart has to begin with small cells.

#include "geometry/distance/signed_distance.h"

namespace shellmatch {

/// Share of the area (length) above which, at this height, another part of the shape is nearer: gaps between limbs, and folds
/// of less than that reach. In [0, 1]. \param height > 0, in the shape's coordinates
template <int Dim>
double narrow_gap_share(const SignedDistance<Dim>& shape, double height);

}  // namespace shellmatch
