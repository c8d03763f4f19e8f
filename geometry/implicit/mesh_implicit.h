#pragma once
/// \file
/// The mesher that turns the zero level of a signed function into a closed surface of well-shaped triangles.

#include "geometry/implicit/implicit_function.h"
#include "geometry/surface/surface.h"

#include <string_view>
#include <vector>

namespace shellmatch {

/// What is finer than the edges. `as_they_come`: sheets and threads of it are joined or cut as the lattice happens to
/// lie, with triangles that may be thin there; the surface is closed whatever the function.
enum class Details { needed, as_they_come };

/// The zero level of f within [0.04, 0.96]^3 as a closed, outward oriented, two-manifold triangle surface
/// with edges of about `edge_length` (in sides of the domain), its vertices on the zero level to rounding.
/// The result does not depend on the number of threads. \throws InputError naming `name` where edge_length is
/// too coarse for the body's details, unless `details` says otherwise, or where the body leaves [0.05, 0.95]^3.
Surface<3> mesh_implicit(const ImplicitFunction& f, double edge_length, std::string_view name,
                         Details details = Details::needed);

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
