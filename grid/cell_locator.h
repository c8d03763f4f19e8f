#pragma once
/// \file
/// Which leaf of an octree contains a point: all that look-ups need of the tree.

#include "base/types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shellmatch {

/// Some five bytes for each cell, so that what is only looked up need not keep the tree: a copy lives on when
/// the tree has gone or has been refined.
template <int Dim>
class CellLocator {
 public:
  static constexpr int max_level = 19;
  using Coord = std::array<std::int32_t, Dim>;

  /// Forgets all cells; put() has to follow for each of them.
  void reset(Index n_cells, int finest_level);
  /// \pre `corner` in units of the cell's side; first_child is no_index for a leaf
  void put(Index cell, int level, const Coord& corner, Index first_child);

  /// The leaf that contains x; x outside the domain is projected onto it first. A point on a face shared by
  /// leaves belongs to the upper one; not-a-number counts as 0. Constant time.
  Index locate(const Vec<Dim>& x) const;

  std::size_t memory_bytes() const { return (table_.capacity() + first_child_.capacity()) * sizeof(Index); }

 private:
  int table_level_ = 0;
  std::vector<Index> table_;        ///< cell at table_level_, or the leaf above it, by coordinates
  std::vector<Index> first_child_;  ///< by cell
};

template <int Dim>
inline Index CellLocator<Dim>::locate(const Vec<Dim>& x) const {
  constexpr double scale = static_cast<double>(1 << max_level);
  std::array<std::uint32_t, Dim> u;
  std::size_t entry = 0;
  for (int k = Dim - 1; k >= 0; --k) {
    // In this order the comparisons send not-a-number to 0.
    double t = x[k] * scale;
    t = t > 0 ? t : 0;
    t = t < scale - 1 ? t : scale - 1;
    u[k] = static_cast<std::uint32_t>(static_cast<std::int32_t>(t));
    entry = (entry << table_level_) | (u[k] >> (max_level - table_level_));
  }
  Index c = table_[entry];
  int shift = max_level - table_level_ - 1;
  for (Index child = first_child_[c]; child != no_index; child = first_child_[c], --shift) {
    c = child;
    for (int k = 0; k < Dim; ++k) c += static_cast<Index>(((u[k] >> shift) & 1u) << k);
  }
  return c;
}

extern template class CellLocator<2>;
extern template class CellLocator<3>;

}  // namespace shellmatch
