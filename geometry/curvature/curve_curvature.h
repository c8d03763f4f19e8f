#pragma once
/// \file
/// Curvature of closed contours at their vertices.

#include "geometry/surface/surface.h"

#include <vector>

namespace shellmatch {

/// The curvature at every vertex of the parabola fitted by least squares to the vertex and its `n_rings`
/// neighbours on each side: the counterpart in the plane of geometry/curvature/mesh_curvature.h. Positive
/// where convex; unit 1/length. NaN where the ring has fewer than 2 n_rings + 1 vertices, or the vertex is
/// not on exactly one ring.
/// \pre n_rings >= 1 (checked)
std::vector<double> curve_curvatures(const Surface<2>& curve, int n_rings = 2);

}  // namespace shellmatch
