#pragma once
/// \file
/// The leaves at each node: the transpose of the table of corners. With it, sums of element vectors at nodes
/// do not depend on the number of threads.

#include "grid/octree/octree.h"

#include <span>
#include <vector>

namespace shellmatch {

/// For every node the leaves of which it is a corner, ascending. A leaf is given by its position in
/// grid.leaves().
template <int Dim>
class NodalIncidence {
 public:
  struct Entry {
    Index leaf;  ///< position in grid.leaves()
    Index corner;
  };

  explicit NodalIncidence(const Octree<Dim>& grid) : first_(static_cast<std::size_t>(grid.n_nodes()) + 1, 0) {
    const auto leaves = grid.leaves();
    for (const Index leaf : leaves)
      for (const Index node : grid.cell(leaf).nodes) ++first_[node + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    entries_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t l = 0; l < leaves.size(); ++l)
      for (int c = 0; c < n_corners<Dim>; ++c)
        entries_[next[grid.cell(leaves[l]).nodes[c]]++] = {static_cast<Index>(l), c};
  }

  std::span<const Entry> leaves_at(Index node) const {
    return {entries_.data() + first_[node], first_[node + 1] - first_[node]};
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<Entry> entries_;
};

}  // namespace shellmatch
