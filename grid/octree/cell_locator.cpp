#include "grid/octree/cell_locator.h"

#include "base/parallel.h"

#include <algorithm>

namespace shellmatch {

namespace {

// Level of the look-up table: about a megabyte of cells in the plane and in space.
template <int Dim>
constexpr int largest_table_level = Dim == 2 ? 9 : 6;

}  // namespace

template <int Dim>
void CellLocator<Dim>::split(std::span<const Index> leaves, int finest_level) {
  const std::size_t n_after = first_child_.size() + n_corners<Dim> * leaves.size();
  first_child_.reserve(n_after);  // resize() alone would allocate spare capacity
  for (const Index leaf : leaves) {
    first_child_[leaf] = n_cells();
    first_child_.resize(first_child_.size() + n_corners<Dim>, no_index);
  }

  finest_level_ = finest_level;
  table_level_ = std::min(finest_level, largest_table_level<Dim>);
  const std::size_t n_entries = std::size_t{1} << (Dim * table_level_);
  table_.reserve(n_entries);
  table_.resize(n_entries);
  parallel_for(table_.size(), [&](std::size_t entry) {
    Index c = 0;
    for (int shift = table_level_ - 1; shift >= 0 && first_child_[c] != no_index; --shift) {
      c = first_child_[c];
      for (int k = 0; k < Dim; ++k) c += static_cast<Index>((entry >> (k * table_level_ + shift)) & 1) << k;
    }
    table_[entry] = c;
  });
}

template <int Dim>
Index CellLocator<Dim>::find(int level, const Coord& corner) const {
  if (level < 0 || level > max_level) return no_index;
  for (const std::int32_t v : corner)
    if (v < 0 || v >= (1 << level)) return no_index;
  Index c = 0;
  int shift = level;  // levels still to go down
  if (level > 0 && level >= table_level_) {
    shift -= table_level_;
    std::size_t entry = 0;
    for (int k = Dim - 1; k >= 0; --k) entry = (entry << table_level_) | static_cast<std::size_t>(corner[k] >> shift);
    c = table_[entry];
    // A leaf coarser than the table fills several entries, that of the sibling among them: then the cell is
    // missing.
    if (shift == 0 && table_[entry ^ 1] == c) return no_index;
  }
  while (--shift >= 0) {
    c = first_child_[c];
    if (c == no_index) return no_index;
    for (int k = 0; k < Dim; ++k) c += ((corner[k] >> shift) & 1) << k;
  }
  return c;
}

template class CellLocator<2>;
template class CellLocator<3>;

}  // namespace shellmatch
