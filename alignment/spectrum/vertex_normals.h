#pragma once
/// \file
/// Normals at the vertices of a surface with given coordinates.

#include "geometry/surface/surface.h"

#include <vector>

namespace shellmatch {

/// Points or normals, one in each row.
using Rows3 = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Unit normals at the vertices of a surface with these facets and the given coordinates (n x 3): means of the facets'
/// normals, weighted by area; zero where they cancel.
Rows3 vertex_normals(const std::vector<std::array<Index, 3>>& facets, const Rows3& coordinates);

}  // namespace shellmatch
