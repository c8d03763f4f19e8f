#pragma once
/// \file
/// The grid of a map, cut at a level beyond which its cells could not be seen, in a form from which the report rebuilds
/// it.

#include "grid/octree/octree.h"

#include <cstdint>
#include <vector>

namespace shellmatch {

template <int Dim>
struct GridOutline {
  int finest_level = 0;  ///< of the cells of this outline
  /// The levels of its cells along the Morton curve: depth first, child c on the upper side along axis k if bit k of c
  /// is set.
  std::vector<std::uint8_t> levels;
  /// Nodes of the grid: the corners of those cells, each once, by their coordinates, the last one before all others.
  std::vector<Index> corners;
};

/// \param most_corners coarser cells are taken until there are no more corners than that
template <int Dim>
GridOutline<Dim> grid_outline(const Octree<Dim>& grid, std::size_t most_corners);

}  // namespace shellmatch
