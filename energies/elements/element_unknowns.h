#pragma once
/// \file
/// The unknowns on which one element depends: the rows of the constraint matrix C that belong to its corners, sorted
/// by unknown.

#include "energies/elements/unknowns.h"

#include <algorithm>
#include <array>
#include <span>

namespace shellmatch {

/// The distinct unknowns of an element, in the order in which its corners refer to them, and for each the corners
/// that depend on it. `Number` identifies an unknown: its index in the grid, or its local index in a cell block.
template <int Dim, class Number>
class ElementUnknowns {
 public:
  /// Upper bound of size(): every corner hangs and has 2^(Dim-1) parents.
  static constexpr int max_size = n_corners<Dim> * (1 << (Dim - 1));

  /// Entry of C in the row of this corner.
  struct CornerEntry {
    int corner;
    float weight;
  };

  /// Adds entry (corner, unknown) of C. Corners are added in ascending order.
  void add(Number unknown, int corner, float weight) {
    const auto end = unknowns_.begin() + size_;
    const auto i = static_cast<int>(std::find(unknowns_.begin(), end, unknown) - unknowns_.begin());
    if (i == size_) {
      unknowns_[i] = unknown;
      n_corners_of_[i] = 0;
      ++size_;
    }
    corners_[i][n_corners_of_[i]++] = {corner, weight};
  }

  int size() const { return size_; }
  Number operator[](int i) const { return unknowns_[i]; }
  /// Column of C that belongs to the i-th unknown.
  std::span<const CornerEntry> corners_of(int i) const {
    return {corners_[i].data(), static_cast<std::size_t>(n_corners_of_[i])};
  }

 private:
  int size_ = 0;
  std::array<Number, max_size> unknowns_;
  std::array<int, max_size> n_corners_of_;
  std::array<std::array<CornerEntry, n_corners<Dim>>, max_size> corners_;
};

/// The unknowns of element number `element`, by their indices in the grid.
template <int Dim>
ElementUnknowns<Dim, Index> element_unknowns(const Unknowns<Dim>& unknowns, std::size_t element) {
  ElementUnknowns<Dim, Index> result;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (const ConstraintEntry& entry : unknowns.constraint_entries(unknowns.elements()[element].nodes[c]))
      result.add(entry.unknown, c, entry.weight);
  return result;
}

}  // namespace shellmatch
