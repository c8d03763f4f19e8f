#pragma once
/// \file
/// Normals for shading.

#include "geometry/surface/surface.h"

#include <array>
#include <vector>

namespace shellmatch {

/// Unit normals at the three corners of every facet: area-weighted means over the facets at the vertex whose
/// normals form an angle of at most `crease_angle` degrees with that of the facet. Round parts are then
/// shaded smoothly and edges stay sharp. An angle of 0 yields facet normals. Facets without area have zero
/// normals.
std::vector<std::array<Vec<3>, 3>> corner_normals(const Surface<3>& surface, double crease_angle);

}  // namespace shellmatch
