#pragma once
/// \file
/// Slices through the grid of a run in space, as in the paper's figure of hierarchical grids.

#include "geometry/surface/surface.h"
#include "grid/octree/octree.h"

#include <array>
#include <string>
#include <vector>

namespace shellmatch {

/// Straight segments of the intersection with a plane, in coordinates along the two axes within the plane.
using SliceLines = std::vector<std::array<Vec<2>, 2>>;

/// Edges of the leaves cut by the plane x[axis] = place of the unit domain, 0 <= place < 1.
SliceLines slice_grid(const Octree<3>& grid, int axis, double place);

/// The curve in which that plane cuts the surface.
SliceLines slice_surface(const Surface<3>& surface, int axis, double place);

/// Draws three slices through the middle of the shapes, one across each axis, with the curves of both shapes; all in
/// the unit domain. \throws EnvironmentError if the file cannot be written
void write_grid_picture(const Octree<3>& grid, const Surface<3>& reference, const Surface<3>& template_shape,
                        const std::string& title, const std::string& path);

}  // namespace shellmatch
