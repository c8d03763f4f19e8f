#pragma once
/// \file
/// Generalised winding number of a surface about a point: 1 inside and 0 outside a closed outward oriented
/// surface, fractional for an open one. Jacobson, Kavan, Sorkine-Hornung, 'Robust inside-outside segmentation
/// using generalized winding numbers', ACM TOG 32(4), 2013.

#include "base/types.h"
#include "geometry/surface/surface.h"

namespace shellmatch {

/// Sum over all facets of the signed angle (plane, over 2 pi) or solid angle (space, over 4 pi) that they
/// subtend at x. Takes time proportional to the number of facets; for checks and small surfaces. For x on a
/// facet, where the winding number is discontinuous, the result is the value of one side or their mean.
template <int Dim>
double winding_number(const Surface<Dim>& surface, const Vec<Dim>& x);

}  // namespace shellmatch
