#pragma once
/// \file
/// Components and genus of a closed surface.

#include "geometry/surface/surface.h"

#include <cstddef>

namespace shellmatch {

struct Topology {
  std::size_t n_vertices = 0;    ///< those of facets
  std::size_t n_components = 0;  ///< connected parts; in the plane closed curves
  int genus = 0;                 ///< sum over the components; 0 in the plane
};

/// By connected parts and, in space, Euler's characteristic. \pre the surface is closed
template <int Dim>
Topology topology(const Surface<Dim>& surface);

}  // namespace shellmatch
