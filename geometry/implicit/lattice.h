#pragma once
/// \file
/// Crude triangulation of a zero level on the body-centred cubic lattice, the first stage of mesh_implicit.

#include "geometry/implicit/implicit_function.h"
#include "geometry/surface/surface.h"

namespace shellmatch {

/// Triangulates the zero level of f within [0.04, 0.96]^3, oriented outward, tetrahedron by tetrahedron of a
/// body-centred cubic lattice with cubes of side `spacing`. Lattice points close to the surface are first
/// moved onto it, which avoids thin triangles: Labelle and Shewchuk, 'Isosurface stuffing', ACM TOG 26(3),
/// 2007, with their two thresholds. Vertices are on the zero level up to the error of linear interpolation.
Surface<3> triangulate_on_lattice(const ImplicitFunction& f, double spacing);

}  // namespace shellmatch
