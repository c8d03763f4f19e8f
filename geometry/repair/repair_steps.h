#pragma once
/// \file
/// The steps of the repair of a triangle surface (geometry/repair/repair.h).

#include "geometry/surface/surface.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

using Triangles = std::vector<std::array<Index, 3>>;

/// Triangulates every polygon: convex ones as fans, others by ear clipping. Repeated consecutive corners are
/// ignored. \param polygon_of takes for each triangle the number of its polygon \param n_given_up takes the number of
/// polygons that cross themselves so much that the search for ears was given up: the rest of each is a fan, whose
/// triangles overlap
Triangles triangulate(const OriginalShape<3>& shape, std::vector<Index>* polygon_of = nullptr,
                      std::size_t* n_given_up = nullptr);

/// Merges vertices with equal coordinates on boundary edges; returns the number of vertices merged; they stay until
/// remove_unused_vertices(). Vertices inside a closed part are not merged, because contact there is not a seam.
std::size_t weld_seams(Surface<3>& surface);

/// Removes triangles with a repeated vertex, and copies of triangles; returns both numbers.
std::pair<std::size_t, std::size_t> remove_repetitions(Surface<3>& surface);

/// \throws InputError where an edge does not have exactly two triangles, with the number of such edges and a
/// position.
void check_closed(const Surface<3>& surface, const std::string& source);

/// Result of orient_consistently().
struct Orientation {
  std::size_t n_turned = 0;  ///< triangles reversed
  std::size_t n_split = 0;   ///< vertices added
};
/// Orients neighbouring triangles consistently and splits vertices at which parts touch. A one-sided surface
/// is cut open. \pre every edge has two triangles
Orientation orient_consistently(Surface<3>& surface);

/// Connected parts: the triangles of each, in the order of their first triangle.
std::vector<std::vector<Index>> connected_parts(const Surface<3>& surface);

/// The number of other parts that contain each part. A part that crosses another is not inside it, nor is one that lies
/// on it with a facet; one that touches it from within with vertices and edges alone is. \pre every part is closed.
std::vector<int> nesting_depths(const Surface<3>& surface, const std::vector<std::vector<Index>>& parts);

/// Removes vertices without a triangle; returns their number.
std::size_t remove_unused_vertices(Surface<3>& surface);

}  // namespace shellmatch
