#pragma once
/// \file
/// Triangles without area, and the sheets that meet at edges of more than two triangles. Everything here keeps what
/// bounds a volume so: each edge keeps the parity of its number of triangles.

#include "geometry/surface/surface.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Heights of triangles and gaps up to this length do not count: a few roundings of the coordinates to single
/// precision, and at most a millionth of the diagonal.
double negligible_length(const std::vector<Vec<3>>& vertices);

/// The facets whose height over their longest edge is at most `height`.
std::vector<Index> flat_triangles(const Surface<3>& surface, double height);

/// Takes such triangles apart: where two corners coincide they become one vertex; otherwise the triangle beyond the
/// longest edge is split at the corner that lies on it, and where there is none nothing is lost. Triangles that are
/// then folded onto each other go, and edges with more than two triangles are taken apart. Vertices stay until
/// remove_unused_vertices(). Returns the number of flat triangles that were there.
std::size_t dissolve_flat_triangles(Surface<3>& surface, double height);

/// Removes pairs of triangles with the same corners that run opposite ways round; returns the number of triangles.
std::size_t remove_folded_pairs(Surface<3>& surface);

/// What becomes of two parts that touch along a face: they are one, with pairs of triangles between them
/// (remove_folded_pairs()), or each has its own face. Faces that touch in part can only be of two.
enum class Touching { is_joined, is_apart };

/// Cuts the surface along edges with more than two triangles: those that bound one wedge of the inside stay together,
/// and vertices are doubled where the sheets around them no longer hang together. Returns the number of such edges.
/// Without any, nothing is changed.
std::size_t take_apart(Surface<3>& surface, Touching touching = Touching::is_joined);

}  // namespace shellmatch
