#pragma once
/// \file
/// Coarser triangulations of a surface.

#include "geometry/surface/surface.h"

namespace shellmatch {

/// A surface of the same topology with about `n_vertices` vertices (closed surfaces; a few more where there are
/// borders), by collapsing the shortest edge to its middle again and again, so that edges end up of similar length. A
/// collapse that would change the topology is left out. Facets that make the surface non-manifold are dropped.
Surface<3> simplified(const Surface<3>& surface, std::size_t n_vertices);

}  // namespace shellmatch
