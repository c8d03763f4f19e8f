#pragma once
/// \file
/// Whether the surroundings of corresponding points look alike, whoever has found the correspondence.

#include "geometry/surface/surface.h"
#include "matching/level/observed_mask.h"

#include <optional>

namespace shellmatch {

/// Mean square difference, 0 to 2, of spin images (alignment/spectrum/spin_images.h) at points of the reference and at
/// those of the template next to which they end, on its side that faces the same way. Radius: 0.2 roots of the area. Of
/// parts, both have only the surroundings that the other has after the map, too. None for curves, surfaces with fewer
/// than 100 vertices and where gaps leave few points. Of maps between people, animals and apes that are right it is
/// 0.03 to 0.35, of those that are wrong 0.45 and more, but for exchanged sides: these are alike (docs/verdict.md).
/// \param reference, template_surface, observed in the unit domain \param deformed the reference's vertices after the
/// map \param one_is_part of the other: lengths are those of the larger one, otherwise in roots of each shape's own
/// area
template <int Dim>
std::optional<double> spin_difference(const Surface<Dim>& reference, const Surface<Dim>& deformed,
                                      const Surface<Dim>& template_surface, const ObservedPair<Dim>& observed,
                                      bool one_is_part);

}  // namespace shellmatch
