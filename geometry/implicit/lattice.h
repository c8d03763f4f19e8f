#pragma once
/// \file
/// Crude triangulation of a zero level on the body-centred cubic lattice, the first stage of mesh_implicit.

#include "geometry/implicit/implicit_function.h"
#include "geometry/surface/surface.h"

namespace shellmatch {

/// Triangles of the zero level of f within [0.04, 0.96]^3, oriented outward: every tetrahedron of a
/// body-centred cubic lattice with cubes of side `spacing` contributes its piece. Lattice points that lie
/// close to the surface are first moved onto it, so that no thin triangles arise: Labelle and Shewchuk,
/// 'Isosurface stuffing', ACM TOG 26(3), 2007, whose two thresholds are used. Vertices are on the zero level
/// up to the error of linear interpolation.
Surface<3> triangulate_on_lattice(const ImplicitFunction& f, double spacing);

}  // namespace shellmatch
