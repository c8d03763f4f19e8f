#pragma once
/// \file
/// A surface of any size made ready for spectral computations.

#include "alignment/options.h"
#include "geometry/surface/surface.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

struct PreparedSurface {
  Surface<3> surface;          ///< connected, every vertex with a facet, in the coordinates of the input
  std::vector<Index> nearest;  ///< for each vertex of the input one of `surface`; no_index on components left out
  double share = 1;            ///< of the input's area; below 1 where other components were left out
  std::size_t rank = 0;        ///< of the component, by area
};

/// The connected component of largest area, simplified (geometry/repair/repair_steps.h) to about options.max_vertices;
/// facets of surfaces below n_least_vertices are divided into four until there are enough. Borders of holes remain.
/// \param rank of the component by area, below n_large_components(): 0 is the largest
/// \throws InputError if no facet has an area
PreparedSurface prepare_surface(const Surface<3>& input, const AlignmentOptions& options, std::size_t rank = 0);

/// Components with more than a twentieth of the area, at least one and at most four.
std::size_t n_large_components(const Surface<3>& input);

/// Surfaces with fewer vertices have too few eigenfunctions.
inline constexpr std::size_t n_least_vertices = 600;

}  // namespace shellmatch
