#pragma once
/// \file
/// The edges of triangles side by side, however many triangles share them.

#include "base/types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shellmatch {

/// One side of a triangle.
struct FacetEdge {
  Index low, high;  ///< its ends, low < high
  Index facet;
  int begin;  ///< it runs from this corner of the facet to the next

  bool same_ends(const FacetEdge& other) const { return low == other.low && high == other.high; }
};

/// The sides of all triangles by their ends and, at equal ends, by their triangles; sides between equal corners are
/// left out. In linear time but for vertices with very many triangles. \param n_vertices all corners are below it
std::vector<FacetEdge> sorted_edges(const std::vector<std::array<Index, 3>>& facets, std::size_t n_vertices);

/// Calls visit(begin, end) for every edge with its sides [begin, end), in the order of sorted_edges().
template <class Visit>
void for_each_edge(const std::vector<FacetEdge>& sorted, Visit&& visit) {
  for (std::size_t i = 0, j = 0; i < sorted.size(); i = j) {
    while (j < sorted.size() && sorted[j].same_ends(sorted[i])) ++j;
    visit(sorted.data() + i, sorted.data() + j);
  }
}

enum class Border { none, allowed };

/// Does the surface bound, as it stands: every edge has two triangles that run through it in opposite directions, and
/// the triangles at every vertex are one fan? \param border allowed: edges may also have one triangle
bool is_oriented_manifold(const std::vector<std::array<Index, 3>>& facets, std::size_t n_vertices,
                          Border border = Border::none);

}  // namespace shellmatch
