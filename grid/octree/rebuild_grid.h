#pragma once
/// \file
/// Rebuilds an octree from the list of its leaves.

#include "grid/octree/octree.h"

#include <optional>
#include <vector>

namespace shellmatch {

/// Level of a cell, and its lower corner in units of its side.
template <int Dim>
struct LeafPlace {
  int level = 0;
  typename Octree<Dim>::Coord corner{};
};

/// The tree whose leaves are exactly these cells, given in any order; nothing if they overlap, leave gaps or are not
/// 2:1 balanced. The memory is proportional to the number of cells. \pre levels in [0, max_level], corners in [0,
/// 2^level)
template <int Dim>
std::optional<Octree<Dim>> rebuild_grid(const std::vector<LeafPlace<Dim>>& leaves);

}  // namespace shellmatch
