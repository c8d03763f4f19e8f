#pragma once
/// \file
/// The steps of the repair of a triangle surface (geometry/repair/repair.h).

#include "geometry/surface/surface.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// A surface of the same topology with about `n_vertices` vertices (closed surfaces; a few more where there are
/// borders), by collapsing the shortest edge to its middle again and again, so that edges end up of similar length. A
/// collapse that would change the topology is left out. Facets that make the surface non-manifold are dropped.
Surface<3> simplified(const Surface<3>& surface, std::size_t n_vertices);

/// Joins borders that lie within `distance` of each other: their vertices that coincide become one, and triangles are
/// split where a vertex of another border lies on their edge. Keeps the surface as it is where that closes nothing.
/// Vertices stay until remove_unused_vertices(). Returns the number of border edges that were closed.
std::size_t stitch_cracks(Surface<3>& surface, double distance);

/// Pairs (f < g) of segments that share a point other than a common end, or an inner point of both. Exact test, sorted.
/// \param most the search ends where more than so many are found: n segments may cross n (n - 1) / 2 times
enum class Contact { any, of_inner_points };
std::vector<std::pair<Index, Index>> crossing_segments(const Surface<2>& outline, Contact contact, std::size_t most);

/// All pairs of a segment and a vertex in its interior (exact test), sorted by segment and along the segment.
std::vector<std::pair<Index, Index>> touching_vertices(const Surface<2>& outline);

/// Whether the path a - p - b passes through the path c - p - d at p, from one side of it to the other. Exact test.
/// \pre no two of the four ends lie in the same direction from p
bool pass_through_at(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d);

/// A common point of both segments, up to rounding.
Vec<2> crossing_point(const Surface<2>& outline, Index f, Index g);

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
