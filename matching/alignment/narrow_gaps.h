#pragma once
/// \file
/// Where parts of a shape lie close to each other: a deformation that is to move them apart has to begin with small
/// cells.

#include "geometry/distance/signed_distance.h"

namespace shellmatch {

/// Share of the area (length) above which, at this height, another part of the shape is nearer than 0.7 of it: gaps
/// between limbs, and folds, up to 1.7 heights wide. In [0, 1]. \param height > 0, in the shape's coordinates
template <int Dim>
double narrow_gap_share(const SignedDistance<Dim>& shape, double height);

/// At three hundredths of the diagonal, the side of a cell at level 5. \pre the surface bounds a body
template <int Dim>
double narrow_gap_share(const Surface<Dim>& surface) {
  return narrow_gap_share(SignedDistance<Dim>(surface), 0.03 * bounding_box(surface.vertices).diagonal());
}

/// Whether to advise a trial of the other direction: the gaps of the reference are clearly more than those of the
/// template.
inline bool has_clearly_more_gaps(double reference, double target) { return reference > 1.3 * target + 0.03; }

}  // namespace shellmatch
