#pragma once
/// \file
/// Surfaces without long edges.

#include "geometry/surface/surface.h"

namespace shellmatch {

/// Cuts every edge that is longer than `length` >= 0 at its middle, once, in all its facets, so that the surface is
/// closed where it was. Vertices keep their numbers and new ones follow. \return whether there was any
bool cut_long_edges(Surface<3>& surface, double length);

/// The same surface with edges of at most `length` > 0. Vertices keep their numbers and new ones follow. Segments are
/// cut into equal parts, edges of triangles at their middles until none is long.
template <int Dim>
Surface<Dim> subdivided(const Surface<Dim>& surface, double length);

}  // namespace shellmatch
