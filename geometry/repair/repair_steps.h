#pragma once
/// \file
/// The single steps of mending a triangle surface. Only repair.cpp calls them.

#include "geometry/surface/surface.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

using Triangles = std::vector<std::array<Index, 3>>;

/// Splits every polygon into triangles: convex ones into fans, others by the triangulation of least area
/// (CGAL's hole filling). Repeated neighbouring corners are left out.
Triangles triangulate(const OriginalShape<3>& shape);

/// Makes one vertex of those that have equal coordinates and lie on boundary edges; returns how many went.
/// Vertices inside a closed part stay apart: there, touching is no seam.
std::size_t weld_seams(Surface<3>& surface);

/// Removes triangles that use a vertex twice, and further copies of the same triangle; returns both counts.
std::pair<std::size_t, std::size_t> remove_repetitions(Surface<3>& surface);

/// \throws InputError where an edge does not have exactly two triangles, saying how many, and where one is.
void check_closed(const Surface<3>& surface, const std::string& source);

/// Number of triangles without area (exact test).
std::size_t count_flat_triangles(const Surface<3>& surface);
/// Removes them by collapses and flips, so that the surface stays closed; false where that fails.
/// \pre closed, manifold, consistently oriented.
bool remove_flat_triangles(Surface<3>& surface);

/// What `orient_consistently` did.
struct Orientation {
  std::size_t n_turned = 0;  ///< triangles
  std::size_t n_split = 0;   ///< vertices added
};
/// Gives neighbouring triangles the same orientation and splits vertices at which parts touch.
/// \pre every edge has two triangles. A one-sided surface is cut open.
Orientation orient_consistently(Surface<3>& surface);

/// Connected parts: the triangles of each, in the order of their first triangle.
std::vector<std::vector<Index>> connected_parts(const Surface<3>& surface);

/// For each part, in how many others it lies. A part that crosses another is not inside it.
/// \pre every part is closed.
std::vector<int> nesting_depths(const Surface<3>& surface, const std::vector<std::vector<Index>>& parts);

/// Removes vertices without a triangle; returns how many.
std::size_t remove_unused_vertices(Surface<3>& surface);

}  // namespace shellmatch
