#pragma once
/// \file
/// Cracks of no width: borders of a surface that lie on each other though their vertices differ.

#include "geometry/surface/surface.h"

#include <cstddef>

namespace shellmatch {

/// Joins borders that lie within `distance` of each other: their vertices that coincide become one, and triangles are
/// split where a vertex of another border lies on their edge. Keeps the surface as it is where that closes nothing.
/// Vertices stay until remove_unused_vertices(). Returns the number of border edges that were closed.
std::size_t stitch_cracks(Surface<3>& surface, double distance);

}  // namespace shellmatch
