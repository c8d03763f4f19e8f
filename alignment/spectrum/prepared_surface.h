#pragma once
/// \file
/// A surface of any size made ready for spectral computations.

#include "alignment/options.h"
#include "geometry/surface/surface.h"

#include <string>

namespace shellmatch {

struct PreparedSurface {
  Surface<3> surface;          ///< connected, every vertex with a facet, in the coordinates of the input
  std::vector<Index> nearest;  ///< for each vertex of the input one of `surface`; no_index on components left out
  double share = 1;            ///< of the input's area; below 1 where other components were left out
  std::vector<std::string> notes = {};  ///< what was changed, in words
};

/// The connected component of largest area, simplified (geometry/repair/repair_steps.h) to about options.max_vertices;
/// facets of surfaces below n_least_vertices are divided into four until there are enough. Borders of holes remain.
/// \throws InputError if no facet has an area
PreparedSurface prepare_surface(const Surface<3>& input, const AlignmentOptions& options);

/// Surfaces with fewer vertices have too few eigenfunctions.
inline constexpr std::size_t n_least_vertices = 600;

}  // namespace shellmatch
