#pragma once
/// \file
/// Making a triangulation of a zero level better without changing its topology, and checking what came out.

#include "geometry/implicit/implicit_function.h"
#include "geometry/surface/surface.h"

namespace shellmatch {

/// Swaps edges of a closed two-manifold as long as the two angles opposite an edge sum up to more than pi
/// (the Delaunay criterion). An edge is left alone where its replacement exists already or where its
/// triangles, seen along the edge's normal, would turn over.
void swap_to_delaunay(Surface<3>& surface);

/// Moves every vertex towards the mean of the triangles around it within its tangent plane, then by a
/// simplified Newton step (with the gradient of the old place) back towards the zero level of f; `n_sweeps`
/// times.
void smooth_tangentially(const ImplicitFunction& f, int n_sweeps, Surface<3>& surface);

/// Is every edge shared by exactly two facets that run along it in opposite directions, and does every vertex
/// have a single fan of facets around it?
bool is_closed_manifold(const Surface<3>& surface);

}  // namespace shellmatch
