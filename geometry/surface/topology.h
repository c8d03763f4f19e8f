#pragma once
/// \file
/// Components, genus and borders of a surface.

#include "geometry/surface/surface.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace shellmatch {

/// A hole, as it is seen by what fills it.
struct BorderLoop {
  std::vector<Index> vertices;  ///< each facet that fills the hole runs through them in this order
  std::vector<Index> opposite;  ///< the third corner of the facet beside vertices k and k + 1
};

/// The holes of a surface in the order of their first edges. None where an edge has more than two facets or two that
/// run through it in the same direction, or where two borders meet in a vertex.
std::optional<std::vector<BorderLoop>> border_loops(const Surface<3>& surface);

struct Topology {
  std::size_t n_vertices = 0;    ///< those of facets
  std::size_t n_components = 0;  ///< connected parts; in the plane closed curves
  int genus = 0;                 ///< sum over the components; 0 in the plane
};

/// By connected parts and, in space, Euler's characteristic. \pre the surface is closed \param least_share of the area
/// (length); smaller components are left out
template <int Dim>
Topology topology(const Surface<Dim>& surface, double least_share = 0);

}  // namespace shellmatch
