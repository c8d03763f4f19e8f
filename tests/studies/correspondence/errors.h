#pragma once
/// \file
/// How far vertices end from where a known correspondence says that they belong.

#include "geometry/surface/surface.h"

#include <span>
#include <vector>

namespace shellmatch {

/// For each point the nearest vertex, the first of several. \pre `vertices` is not empty
std::vector<Index> nearest_vertices(std::span<const Vec<3>> vertices, std::span<const Vec<3>> points);

/// Lengths of the shortest paths along edges of the template from vertex ends[i] to vertex belong[i], over the square
/// root of the template's area; infinite between its components. Paths along edges are up to 15 % longer than those
/// across facets where these are equilateral, 10 % on average: Kim, Lipman, Funkhouser, Blended intrinsic maps
/// (SIGGRAPH 2011) measure correspondences in this unit. \throws InputError where the template has no area
std::vector<double> geodesic_errors(const Surface<3>& template_surface, std::span<const Index> ends,
                                    std::span<const Index> belong);

/// Distances from ends[i] to vertex belong[i] of the template, in diagonals of its bounding box.
/// \throws InputError where the template has no extent
std::vector<double> euclidean_errors(std::span<const Vec<3>> template_vertices, std::span<const Vec<3>> ends,
                                     std::span<const Index> belong);

}  // namespace shellmatch
