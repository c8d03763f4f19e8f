#include "grid/cell_locator.h"

#include <algorithm>

namespace shellmatch {

namespace {

// Level of the look-up table: about a megabyte of cells in the plane and in space.
template <int Dim>
constexpr int largest_table_level = Dim == 2 ? 9 : 6;

}  // namespace

template <int Dim>
void CellLocator<Dim>::reset(Index n_cells, int finest_level) {
  finest_level_ = finest_level;
  table_level_ = std::min(finest_level, largest_table_level<Dim>);
  table_.resize(std::size_t{1} << (Dim * table_level_));
  first_child_.resize(static_cast<std::size_t>(n_cells));
}

template <int Dim>
void CellLocator<Dim>::put(Index c, int level, const Coord& corner, Index first_child) {
  first_child_[c] = first_child;
  if (level > table_level_ || (level < table_level_ && first_child != no_index)) return;
  const int shift = table_level_ - level;
  const std::size_t n_entries = std::size_t{1} << (Dim * shift);
  for (std::size_t e = 0; e < n_entries; ++e) {
    std::size_t entry = 0;
    for (int k = Dim - 1; k >= 0; --k) {
      const std::size_t offset = (e >> (k * shift)) & ((std::size_t{1} << shift) - 1);
      entry = (entry << table_level_) | ((static_cast<std::size_t>(corner[k]) << shift) + offset);
    }
    table_[entry] = c;
  }
}

template class CellLocator<2>;
template class CellLocator<3>;

}  // namespace shellmatch
