#pragma once
/// \file
/// Facets of a surface that meet others than where they are joined, by exact predicates.

#include "geometry/surface/surface.h"

#include <vector>

namespace shellmatch {

/// Facets that cross, touch or overlap another one outside of the vertices and edges that both share; in
/// ascending order. The surface may be open or not manifold. Facets without measure are left out.
/// \pre finite coordinates.
std::vector<Index> self_intersecting_facets(const Surface<2>& surface);
std::vector<Index> self_intersecting_facets(const Surface<3>& surface);

}  // namespace shellmatch
