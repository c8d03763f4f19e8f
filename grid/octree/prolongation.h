#pragma once
/// \file
/// Prolongation of nodal fields to a refined grid.

#include "base/error.h"
#include "grid/octree/octree.h"

#include <vector>

namespace shellmatch {

/// Represents a finite element function on the refined grid: appends its values at the new nodes,
/// [n_old_nodes, refined.n_nodes()). The function does not change, because the spaces are nested. The grid
/// may have been refined several times since.
/// \pre `nodal` holds n_old_nodes values, those of hanging nodes set (see distribute). T supports sums and
/// multiples.
template <int Dim, class T>
void prolongate(const Octree<Dim>& refined, Index n_old_nodes, std::vector<T>& nodal) {
  SHELLMATCH_CHECK(static_cast<std::size_t>(n_old_nodes) == nodal.size(), "the field does not belong to the old grid");
  nodal.resize(refined.n_nodes());
  std::vector<char> known(refined.n_nodes() - n_old_nodes, 0);
  // In ascending order a cell precedes its descendants, so its corner values are known when its children are
  // visited.
  for (Index c = 0; c < refined.n_cells(); ++c) {
    const auto& parent = refined.cell(c);
    if (parent.is_leaf()) continue;
    for (int child = 0; child < n_corners<Dim>; ++child)
      for (int corner = 0; corner < n_corners<Dim>; ++corner) {
        const Index node = refined.cell(parent.first_child + child).nodes[corner];
        if (node < n_old_nodes || known[node - n_old_nodes]) continue;
        known[node - n_old_nodes] = 1;
        // `middle`: the axes along which the node is in the middle of the parent; `side`: its side along the
        // others.
        const int middle = child ^ corner, side = child & corner;
        double weight = 1;
        for (int k = 0; k < Dim; ++k)
          if ((middle >> k) & 1) weight *= 0.5;
        T value = weight * nodal[parent.nodes[side]];
        for (int p = 0; p < n_corners<Dim>; ++p)
          if ((p & ~middle) == side && p != side) value += weight * nodal[parent.nodes[p]];
        nodal[node] = value;
      }
  }
}

}  // namespace shellmatch
