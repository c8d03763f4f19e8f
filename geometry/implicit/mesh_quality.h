#pragma once
/// \file
/// Improvement of a triangulated zero level without a change of topology, and checks of the result.

#include "geometry/implicit/implicit_function.h"
#include "geometry/surface/surface.h"

#include <vector>

namespace shellmatch {

/// Flips edges of a closed two-manifold as long as the two angles opposite an edge sum to more than pi (the
/// Delaunay criterion). An edge is not flipped if the new edge exists already or if a triangle would be
/// inverted, as seen along the normal of the edge.
void swap_to_delaunay(Surface<3>& surface);

/// Moves every vertex within its tangent plane towards the mean of the triangles around it, and then back to
/// the zero level of f by a simplified Newton step (with the gradient at the old position); `n_sweeps` times.
void smooth_tangentially(const ImplicitFunction& f, int n_sweeps, Surface<3>& surface);

/// The vertices, ascending, at which the surface is no closed two-manifold: an edge is not shared by exactly two facets
/// with opposite directions, or the facets form no single fan.
std::vector<Index> vertices_without_a_fan(const Surface<3>& surface);

inline bool is_closed_manifold(const Surface<3>& surface) {
  return !surface.facets.empty() && vertices_without_a_fan(surface).empty();
}

}  // namespace shellmatch
