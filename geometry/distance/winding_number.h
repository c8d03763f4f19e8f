#pragma once
/// \file
/// Generalised winding number: how often a surface surrounds a point. 1 inside and 0 outside of a closed
/// outward oriented surface, in between for an open one. Jacobson, Kavan, Sorkine-Hornung, 'Robust
/// inside-outside segmentation using generalized winding numbers', ACM TOG 32(4), 2013.

#include "base/types.h"
#include "geometry/surface/surface.h"

namespace shellmatch {

/// Sum over all facets of the signed angle (plane, over 2 pi) or solid angle (space, over 4 pi) that they
/// fill as seen from x. The time is proportional to the number of facets: for checks and small surfaces. On a
/// facet the value jumps; the result there is one of both sides or their mean.
template <int Dim>
double winding_number(const Surface<Dim>& surface, const Vec<Dim>& x);

}  // namespace shellmatch
