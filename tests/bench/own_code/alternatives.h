#pragma once
/// \file
/// What libraries offer in the place of our own code, each behind a function of plain types.

#include "geometry/picture/read_mask.h"
#include "geometry/surface/surface.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch::own_code {

/// Distance from a point to a surface; what it is built from lives as long as the function.
using Distance = std::function<double(const Vec<3>&)>;

/// Our own: FacetTree and closest_point_on_facet().
Distance facet_tree_distance(const Surface<3>& surface);
/// AABB_tree over Simple_cartesian<double>.
Distance cgal_distance(const Surface<3>& surface);
/// rtcPointQuery of one thread, with closest_point_on_facet() in its callback. \pre the surface outlives it
Distance embree_distance(const Surface<3>& surface);

/// Nothing where the library reports an error.
using MeshReader = std::function<std::optional<OriginalShape<3>>(const std::string& path)>;

std::optional<OriginalShape<3>> cgal_ply(const std::string& path);
std::optional<OriginalShape<3>> vtk_ply(const std::string& path);

std::optional<GreyImage> vtk_pgm(const std::string& path);

/// Points of the contour of the mask: vtkImageGaussianSmooth and vtkMarchingSquares, in the axes of mask_rings().
std::vector<Vec<2>> vtk_mask_points(const GreyImage& image, double deviation);

}  // namespace shellmatch::own_code
