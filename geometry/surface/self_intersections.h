#pragma once
/// \file
/// Self-intersections of a surface, by exact predicates.

#include "geometry/surface/surface.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Surfaces with more facets are not searched where nobody asked for it: that takes seconds.
inline constexpr std::size_t self_intersection_limit = 400'000;

/// Facets that cross, touch or overlap another facet outside the vertices and edges that both share,
/// ascending. The surface may be open or non-manifold. Facets of measure 0 are ignored.
/// \pre finite coordinates.
std::vector<Index> self_intersecting_facets(const Surface<2>& surface);
std::vector<Index> self_intersecting_facets(const Surface<3>& surface);

}  // namespace shellmatch
