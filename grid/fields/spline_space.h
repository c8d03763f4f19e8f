#pragma once
/// \file
/// Functions on the octree that are quadratic splines along each axis: C1 throughout, across levels too.

#include "base/error.h"
#include "base/parallel.h"
#include "grid/octree/cell_locator.h"
#include "grid/octree/key_map.h"
#include "grid/octree/octree.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace shellmatch {

/// Weights of the three coefficients along one axis at t in [0, 1] of a cell, and their derivatives by t:
/// uniform quadratic B-splines with knots on the cell's faces. T is a number, or a vector of them.
template <class T>
struct SplineWeights {
  std::array<T, 3> value, slope;
  explicit SplineWeights(const T& t)
      : value{0.5 * (1.0 - t) * (1.0 - t), 0.5 + t * (1.0 - t), 0.5 * t * t}, slope{t - 1.0, 1.0 - 2.0 * t, t} {}
};

/// On a leaf a function is the tensor product of quadratic B-splines with 3^Dim coefficients, one for the
/// leaf and one for each neighbour of its size. Where a neighbour is larger, the coefficients of the leaf and
/// of what would be its neighbours are those that represent the larger cells' spline by smaller ones (knot
/// insertion: 3/4 and 1/4 along each axis). So both splines are the same function next to the face between
/// them, which is why the whole is C1: truncated hierarchical B-splines (Giannelli, Juettler, Speleers 2012)
/// without a look-up over levels. Coefficients outside the domain continue those inside.
template <int Dim>
class SplineSpace {
 public:
  static constexpr int n_local = Dim == 2 ? 9 : 27;
  /// Numbers of a leaf's coefficients; the first axis runs fastest, the leaf's own stands in the middle. And
  /// some more, without meaning, that fill up registers.
  struct alignas(64) Local {
    std::array<Index, Dim == 2 ? 16 : 32> c;
    Index operator[](int n) const { return c[n]; }
  };
  using Coord = typename Octree<Dim>::Coord;

  /// `grid` must not be refined, and must live on, until forget_grid().
  explicit SplineSpace(const Octree<Dim>& grid);

  /// Frees what only coefficients() reads. Look-ups need the grid no longer.
  void forget_grid();

  Index n_coefficients() const { return n_coefficients_; }
  int finest_level() const { return finest_level_; }

  /// The leaf that contains x, projected onto the domain: the number of its own coefficient.
  Index locate(const Vec<Dim>& x) const { return number_of(locator_.locate(x)); }
  /// The same for eight points at once, coordinate by coordinate.
  void locate(const std::array<std::array<double, 8>, Dim>& x, std::array<Index, 8>& leaf) const {
    locator_.locate(x, leaf);
    for (Index& i : leaf) i = number_of(i);
  }
  /// Prefetches into the cache what the next three functions read.
  void prefetch(Index leaf) const {
    const char* record = reinterpret_cast<const char*>(&siblings_of(leaf));
    for (std::size_t line = 0; line < sizeof(Siblings); line += 64) __builtin_prefetch(record + line);
  }
  int level_of(Index leaf) const { return siblings_of(leaf).level; }
  Coord corner_of(Index leaf) const;  ///< in units of its side
  Local coefficients_of(Index leaf) const;

  /// Coefficients of functions from their values at the nodes, hanging ones included. The first `n_quasi_interpolated` components
  /// are those of the quasi-interpolant, which reproduces quadratic polynomials away from coarser neighbours and from
  /// the boundary and linear ones everywhere: error of third order. The others are the means over the corners of the
  /// cells, which stay within the range of the values around and so keep matrices positive definite: error of second
  /// order. nodal(n, i) is component i at node n; at(c, i) is a reference to component i of coefficient c, which the
  /// caller has set to 0.
  /// \pre forget_grid() has not been called
  template <class Nodal, class At>
  void coefficients(std::size_t n_components, std::size_t n_quasi_interpolated, const Nodal& nodal, const At& at) const;

 private:
  static constexpr int n_siblings = n_corners<Dim>;
  static constexpr int n_registers = Dim - 1;  ///< of 16 numbers, for those of a leaf
  typedef Index Numbers __attribute__((vector_size(64)));
  /// The children of one cell, whose coefficients stand one after the other. Around them are 3^Dim such
  /// groups of their size, in which all their neighbours lie: one record for all of them is not only smaller,
  /// it is more often in the caches.
  struct alignas(64) Siblings {
    std::array<Index, n_local>
        first;           ///< coefficient of each group around, or no_index where none of it was asked for
    Coord corner;        ///< the parent's, in units of its side
    std::int32_t level;  ///< of the siblings
  };
  struct Derived {
    Index coefficient;
    bool outside;  ///< of the domain: 2 source[0] - source[1], or source[0] where not quasi-interpolated
    std::array<Index, n_corners<Dim>> source;  ///< else of larger cells: bit k says which are on the far side
  };
  enum class Made : char { no, sampled, derived };

  // Cells are numbered from the root, behind which siblings follow siblings. It gets a group to itself.
  static Index number_of(Index cell) { return cell == 0 ? 0 : cell + n_siblings - 1; }
  static Index cell_of(Index coefficient) { return coefficient == 0 ? 0 : coefficient - n_siblings + 1; }
  bool is_of_cell(Index coefficient) const {
    return coefficient == 0 || (coefficient >= n_siblings && coefficient < n_of_cells_);
  }
  const Siblings& siblings_of(Index coefficient) const {
    return siblings_[static_cast<std::uint32_t>(coefficient) / n_siblings];
  }
  static constexpr auto steps();
  static constexpr auto steps_in_registers();
  Index neighbour(Index coefficient, int n) const;
  Index group_in_grid(int level, const Coord& parent) const;
  void ask_for_neighbours(Index leaf);
  Index coefficient_at(int level, const Coord& corner);
  void make(Index coefficient, int level, const Coord& corner);
  bool is_among_its_size(Index coefficient, int level, const Coord& corner) const;
  void derive(Index coefficient, int level, const Coord& corner);

  const Octree<Dim>* grid_;
  CellLocator<Dim> locator_;
  int finest_level_;
  std::vector<Siblings> siblings_;  ///< by number of a cell's coefficient over n_siblings
  Index n_of_cells_, n_coefficients_;
  std::vector<Made> made_;        ///< by coefficient
  std::vector<Derived> derived_;  ///< none before its sources
  KeyMap others_;                 ///< first coefficients of groups that are not of the grid
};

/// Where the neighbours of each sibling are: number of the group around, and number in it.
template <int Dim>
constexpr auto SplineSpace<Dim>::steps() {
  struct Step {
    std::uint8_t group, child;
  };
  std::array<std::array<Step, n_local>, n_siblings> all{};
  for (int child = 0; child < n_siblings; ++child)
    for (int n = 0; n < n_local; ++n) {
      int group = 0, sibling = 0;
      for (int k = 0, rest = n, stride = 1; k < Dim; ++k, rest /= 3, stride *= 3) {
        const int place = ((child >> k) & 1) + rest % 3 + 1;  // two to a group
        group += stride * (place / 2);
        sibling |= (place % 2) << k;
      }
      all[child][n] = {static_cast<std::uint8_t>(group), static_cast<std::uint8_t>(sibling)};
    }
  return all;
}

/// The same by register: 16 numbers of groups, 16 of children.
template <int Dim>
constexpr auto SplineSpace<Dim>::steps_in_registers() {
  struct alignas(64) Steps {
    std::array<Index, 16 * n_registers> group, child;
  };
  std::array<Steps, n_siblings> all{};
  for (int child = 0; child < n_siblings; ++child)
    for (int n = 0; n < n_local; ++n) {
      all[child].group[n] = steps()[child][n].group;
      all[child].child[n] = steps()[child][n].child;
    }
  return all;
}

template <int Dim>
inline Index SplineSpace<Dim>::neighbour(Index coefficient, int n) const {
  static constexpr auto table = steps();
  const auto step = table[coefficient % n_siblings][n];
  const Index first = siblings_of(coefficient).first[step.group];
  return first == no_index ? no_index : first + step.child;
}

template <int Dim>
inline typename SplineSpace<Dim>::Coord SplineSpace<Dim>::corner_of(Index leaf) const {
  Coord corner = siblings_of(leaf).corner;
  for (int k = 0; k < Dim; ++k) corner[k] = 2 * corner[k] + ((leaf >> k) & 1);
  return corner;
}

template <int Dim>
inline typename SplineSpace<Dim>::Local SplineSpace<Dim>::coefficients_of(Index leaf) const {
  static constexpr auto table = steps_in_registers();
  // Eight groups are among them at most, each several times: what stands where is known from the sibling alone.
  const Siblings& s = siblings_of(leaf);
  const auto& [group, child] = table[leaf % n_siblings];
  static_assert(sizeof(Siblings) == sizeof(Local));
  Local local;
  Numbers first[n_registers];
  std::memcpy(first, &s, sizeof first);
  for (int r = 0; r < n_registers; ++r) {
    Numbers at;
    std::memcpy(&at, group.data() + 16 * r, sizeof at);
    const Numbers found = n_registers == 1 ? __builtin_shuffle(first[0], at) : __builtin_shuffle(first[0], first[n_registers - 1], at);
    Numbers add;
    std::memcpy(&add, child.data() + 16 * r, sizeof add);
    const Numbers sum = found + add;
    std::memcpy(local.c.data() + 16 * r, &sum, sizeof sum);
  }
  return local;
}

template <int Dim>
template <class Nodal, class At>
void SplineSpace<Dim>::coefficients(std::size_t n_components, std::size_t n_quasi_interpolated, const Nodal& nodal,
                                    const At& at) const {
  SHELLMATCH_CHECK(grid_ != nullptr, "the grid of the splines is forgotten");
  // Two components at a time, so that means take little memory.
  constexpr std::size_t n_together = 2;
  using Some = std::array<double, n_together>;
  std::vector<Some> mean(static_cast<std::size_t>(grid_->n_cells()));
  for (std::size_t begin = 0; begin < n_components; begin += n_together) {
    const std::size_t n = std::min(n_together, n_components - begin);
    const auto combine = [&](Some& sum, double weight, const Some& row, std::size_t n_all) {
      for (std::size_t i = 0; i < n_together && begin + i < n_all; ++i) sum[i] += weight * row[i];
    };
    parallel_for(mean.size(), [&](std::size_t c) {
      mean[c] = {};
      for (const Index node : grid_->cell(static_cast<Index>(c)).nodes)
        for (std::size_t i = 0; i < n; ++i) mean[c][i] += 1.0 / n_corners<Dim> * nodal(node, begin + i);
    });
    parallel_for(mean.size(), [&](std::size_t cell) {
      const Index c = number_of(static_cast<Index>(cell));
      if (made_[c] != Made::sampled) return;
      Some row = mean[cell];
      for (int k = 0, stride = 1; k < Dim; ++k, stride *= 3) {
        const Index below = neighbour(c, n_local / 2 - stride), above = neighbour(c, n_local / 2 + stride);
        if (!is_of_cell(below) || !is_of_cell(above)) continue;  // continued linearly
        combine(row, 0.5, mean[cell], n_quasi_interpolated);
        combine(row, -0.25, mean[cell_of(below)], n_quasi_interpolated);
        combine(row, -0.25, mean[cell_of(above)], n_quasi_interpolated);
      }
      for (std::size_t i = 0; i < n; ++i) at(c, begin + i) = row[i];
    });
  }
  for (const Derived& d : derived_) {
    if (d.outside) {
      for (std::size_t i = 0; i < n_components; ++i) {
        const double first = at(d.source[0], i);
        at(d.coefficient, i) = i < n_quasi_interpolated ? first + first - at(d.source[1], i) : first;
      }
      continue;
    }
    for (int c = 0; c < n_corners<Dim>; ++c) {
      double weight = 1;
      for (int k = 0; k < Dim; ++k) weight *= (c >> k) & 1 ? 0.25 : 0.75;
      for (std::size_t i = 0; i < n_components; ++i)
        at(d.coefficient, i) += weight * at(d.source[c], i);
    }
  }
}

extern template class SplineSpace<2>;
extern template class SplineSpace<3>;

}  // namespace shellmatch
