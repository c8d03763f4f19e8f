#pragma once
/// \file

#include "base/types.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shellmatch {

/// Disjoint sets of 0, ..., n - 1 with union; each is represented by its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index i, Index j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace shellmatch
