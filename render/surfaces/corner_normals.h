#pragma once
/// \file
/// Normals for shading.

#include "geometry/surface/surface.h"

#include <array>
#include <vector>

namespace shellmatch {

/// Unit normals at the three corners of every facet: means over those facets at the vertex whose normals
/// enclose at most `crease_angle` degrees with the facet's own, weighted by area, so that round parts are
/// smooth and edges stay sharp. 0 gives facet normals. Facets without area get zero normals.
std::vector<std::array<Vec<3>, 3>> corner_normals(const Surface<3>& surface, double crease_angle);

/// Unit normals at the vertices, weighted by area; zero where there is none.
std::vector<Vec<3>> vertex_normals(const Surface<3>& surface);

}  // namespace shellmatch
