#pragma once
/// \file
/// Point location in an octree, without the nodes and levels of its cells.

#include "base/registers.h"
#include "base/types.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace shellmatch {

/// Finds cells by descending from a table at a coarse level. It takes four bytes for each cell and about a
/// megabyte for the table. A copy stays valid after the octree has been destroyed or refined, so code that
/// only locates points need not keep the octree.
template <int Dim>
class CellLocator {
 public:
  static constexpr int max_level = 19;
  using Coord = std::array<std::int32_t, Dim>;
  template <class T>
  using Eight = std::array<T, 8>;

  /// Gives each of these leaves 2^Dim children. They are numbered after the existing cells, leaf by leaf.
  void split(std::span<const Index> leaves, int finest_level);

  Index n_cells() const { return static_cast<Index>(first_child_.size()); }
  /// The first of the cell's 2^Dim children, which are numbered consecutively; no_index for a leaf.
  Index first_child(Index cell) const { return first_child_[cell]; }

  /// The leaf that contains x; x outside the domain is projected onto the domain first. A point on a face
  /// shared by two leaves belongs to the upper one. NaN is treated as 0. The cost is bounded by the number of
  /// levels.
  Index locate(const Vec<Dim>& x) const;
  /// The same for eight points at once; x[k] holds their coordinates k. The eight descents are independent
  /// and overlap in the processor.
  void locate(const std::array<Eight<double>, Dim>& x, Eight<Index>& leaf) const;
  /// The cell, leaf or not, of this level with this lower corner, in units of its side; no_index where the
  /// octree has none or the corner is outside the domain.
  Index find(int level, const Coord& corner) const;

  std::size_t memory_bytes() const { return (table_.capacity() + first_child_.capacity()) * sizeof(Index); }

 private:
  // Converts to units of 2^-max_level and clamps to the domain; T is a number or a vector of numbers. In this
  // order the comparisons turn NaN into 0.
  template <class T>
  static void project(T& x) {
    constexpr double scale = static_cast<double>(1 << max_level);
    x *= scale;
    x = x > 0.0 ? x : T{};
    x = x < scale - 1 ? x : T{} + (scale - 1);
  }

  int table_level_ = 0, finest_level_ = 0;
  std::vector<Index> table_{0};               ///< cell at table_level_, or the leaf that contains it, by coordinates
  std::vector<Index> first_child_{no_index};  ///< by cell; initially the root alone
};

template <int Dim>
inline Index CellLocator<Dim>::locate(const Vec<Dim>& x) const {
  std::array<std::uint32_t, Dim> u;
  std::size_t entry = 0;
  for (int k = Dim - 1; k >= 0; --k) {
    double t = x[k];
    project(t);
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

template <int Dim>
inline void CellLocator<Dim>::locate(const std::array<Eight<double>, Dim>& x, Eight<Index>& leaf) const {
  constexpr std::size_t n_lanes = register_bytes / sizeof(double), n_parts = 8 / n_lanes;
  using Doubles = Register<double, n_lanes>;
  using Ints = Register<std::int32_t, n_lanes>;
  std::array<std::array<Ints, n_parts>, Dim> u;
  Eight<Index> cell;
  for (std::size_t p = 0; p < n_parts; ++p) {
    Ints entry{};
    for (int k = Dim - 1; k >= 0; --k) {
      auto t = load<Doubles>(&x[k][p * n_lanes]);
      project(t);
      u[k][p] = __builtin_convertvector(t, Ints);
      entry = (entry << table_level_) | (u[k][p] >> (max_level - table_level_));
    }
    for (std::size_t i = 0; i < n_lanes; ++i) cell[p * n_lanes + i] = table_[static_cast<std::uint32_t>(entry[i])];
  }
  for (int shift = max_level - table_level_ - 1; shift >= max_level - finest_level_; --shift) {
    Eight<Index> first;
    for (std::size_t i = 0; i < first.size(); ++i) first[i] = first_child_[static_cast<std::uint32_t>(cell[i])];
    for (std::size_t p = 0; p < n_parts; ++p) {
      auto child = load<Ints>(&first[p * n_lanes]);
      const Ints is_leaf = child < 0;
      for (int k = 0; k < Dim; ++k) child += ((u[k][p] >> shift) & 1) << k;
      store(is_leaf ? load<Ints>(&cell[p * n_lanes]) : child, &cell[p * n_lanes]);
    }
  }
  leaf = cell;
}

extern template class CellLocator<2>;
extern template class CellLocator<3>;

}  // namespace shellmatch
