#pragma once
/// \file
/// Quadratic splines on the octree: C1 everywhere, also where the level changes.

#include "base/registers.h"
#include "grid/octree/cell_locator.h"
#include "grid/octree/octree.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <vector>

namespace shellmatch {

/// Values and derivatives, along one axis at t in [0, 1], of the three uniform quadratic B-splines that are
/// non-zero on a cell; their knots are the faces of the cells. T is a number or a vector of numbers.
template <class T>
struct SplineWeights {
  std::array<T, 3> value, slope;
  explicit SplineWeights(const T& t)
      : value{0.5 * (1.0 - t) * (1.0 - t), 0.5 + t * (1.0 - t), 0.5 * t * t}, slope{t - 1.0, 1.0 - 2.0 * t, t} {}
};

/// On a leaf, a function is a tensor product spline of degree 2 with 3^Dim coefficients, one for the leaf and
/// one for each neighbour position of its size. Where a neighbour is larger, the coefficients of the leaf and
/// of the missing neighbours are obtained by knot insertion (weights 3/4 and 1/4 along each axis), so that
/// they represent the spline of the larger cells. Both splines then agree next to the common face, and the
/// function is C1. The space is that of truncated hierarchical B-splines (Giannelli, Juettler, Speleers
/// 2012), evaluated without a search over levels. Coefficients outside the domain are extrapolated from those
/// inside.
template <int Dim>
class SplineSpace {
 public:
  static constexpr int n_local = Dim == 2 ? 9 : 27;
  /// Indices of a leaf's 3^Dim coefficients, the first axis fastest; the leaf's own is in the middle. The
  /// entries behind them pad the array to whole registers and are not valid indices.
  struct alignas(64) Local {
    std::array<Index, Dim == 2 ? 16 : 32> c;
    Index operator[](int n) const { return c[n]; }
  };
  using Coord = typename Octree<Dim>::Coord;

  /// Keeps a reference to `grid`, which must exist and must not be refined until forget_grid() has been
  /// called.
  explicit SplineSpace(const Octree<Dim>& grid);

  /// Frees the data that only coefficients() reads. The other functions do not need the grid.
  void forget_grid();

  Index n_coefficients() const { return n_coefficients_; }
  int finest_level() const { return finest_level_; }

  /// The leaf that contains x, given by the index of its own coefficient. x is projected onto the domain
  /// first.
  Index locate(const Vec<Dim>& x) const { return number_of(locator_.locate(x)); }
  /// The same for eight points at once; x[k] holds their coordinates k.
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

  /// Coefficients of functions from their values at the nodes, hanging ones included. The first n_quasi_interpolated
  /// of n components are those of the quasi-interpolant, which reproduces quadratic polynomials away from coarser
  /// neighbours and from the boundary, and linear ones everywhere: error of third order. The others are the means over
  /// the corners of the cells, which stay within the range of the nodal values and so keep matrices positive definite:
  /// error of second order. nodal(k, i) is component i at node k; at(c, i) is a reference to component i of coefficient
  /// c, a number of single or double precision.
  /// Defined in grid/fields/spline_coefficients.h. \pre forget_grid() has not been called
  template <std::size_t n, std::size_t n_quasi_interpolated, class Nodal, class At>
  void coefficients(const Nodal& nodal, const At& at) const;

 private:
  static constexpr int n_siblings = n_corners<Dim>;
  static constexpr int n_registers = Dim - 1;  ///< of 16 indices, for the coefficients of a leaf
  using Numbers = Register<Index, 16>;
  /// The children of one cell, whose coefficients have consecutive indices. All their neighbours belong to
  /// the 3^Dim groups of siblings around them, so one record serves all siblings; it is smaller than one per
  /// cell and is more often in the caches.
  struct alignas(64) Siblings {
    std::array<Index, n_local>
        first;           ///< first coefficient of each group around; no_index where none of them is needed
    Coord corner;        ///< the parent's, in units of its side
    std::int32_t level;  ///< of the siblings
  };
  struct Derived {
    Index coefficient;
    bool outside;  ///< outside the domain: 2 source[0] - source[1], or source[0] where not quasi-interpolated
    std::array<Index, n_corners<Dim>> source;  ///< else by knot insertion from these; bit k: farther along axis k
  };
  enum class Made : char { no, sampled, derived };

  // The octree numbers the root first and then siblings consecutively. Here the root has a group of its own.
  static Index number_of(Index cell) { return cell == 0 ? 0 : cell + n_siblings - 1; }
  static Index cell_of(Index coefficient) { return coefficient == 0 ? 0 : coefficient - n_siblings + 1; }
  bool is_of_cell(Index coefficient) const {
    return coefficient == 0 || (coefficient >= n_siblings && coefficient < n_of_cells_);
  }
  const Siblings& siblings_of(Index coefficient) const {
    return siblings_[static_cast<std::uint32_t>(coefficient) / n_siblings];
  }
  /// The mean over the corners of a cell of components [begin, begin + n).
  template <std::size_t begin, std::size_t n, class Nodal>
  std::array<double, n> mean(Index cell, const Nodal& nodal) const;
  template <std::size_t begin, std::size_t n, class Nodal, class At>
  void quasi_interpolate(const Nodal& nodal, const At& at) const;
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
  std::vector<Siblings> siblings_;  ///< of coefficient c: siblings_[c / n_siblings]
  Index n_of_cells_, n_coefficients_;
  std::vector<Made> made_;        ///< by coefficient
  std::vector<Derived> derived_;  ///< ordered such that sources precede their dependents
  std::unordered_map<std::uint64_t, Index>
      others_;  ///< by key_of(): first coefficients of the groups that are not cells of the grid
};

/// For each neighbour of each sibling: the group that contains the neighbour, and its number in that group.
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
        const int place = ((child >> k) & 1) + rest % 3 + 1;  // two cells to a group
        group += stride * (place / 2);
        sibling |= (place % 2) << k;
      }
      all[child][n] = {static_cast<std::uint8_t>(group), static_cast<std::uint8_t>(sibling)};
    }
  return all;
}

/// The same table in the layout of registers of 16 indices.
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
  // The neighbours lie in at most eight groups; which of them depends on the sibling alone.
  const Siblings& s = siblings_of(leaf);
  const auto& [group, child] = table[leaf % n_siblings];
  Local local;
  if constexpr (register_bytes < sizeof(Numbers)) {
    for (int n = 0; n < n_local; ++n) local.c[n] = s.first[group[n]] + child[n];
    return local;
  }
  static_assert(sizeof(Siblings) == sizeof(Local));
  Numbers first[n_registers];
  std::memcpy(first, &s, sizeof first);
  for (int r = 0; r < n_registers; ++r) {
    const auto at = load<Numbers>(group.data() + 16 * r), add = load<Numbers>(child.data() + 16 * r);
    const Numbers found =
        n_registers == 1 ? __builtin_shuffle(first[0], at) : __builtin_shuffle(first[0], first[n_registers - 1], at);
    store(found + add, local.c.data() + 16 * r);
  }
  return local;
}

extern template class SplineSpace<2>;
extern template class SplineSpace<3>;

}  // namespace shellmatch
