#pragma once
/// \file
/// Functions on the octree that are quadratic splines along each axis: C1 throughout, across levels too.

#include "base/parallel.h"
#include "grid/octree.h"

#include <array>
#include <span>
#include <tuple>
#include <vector>

namespace shellmatch {

/// Weights of the three coefficients along one axis at t in [0, 1] of a cell, and their derivatives by t:
/// uniform quadratic B-splines with knots on the cell's faces.
struct SplineWeights {
  std::array<double, 3> value, slope;
  explicit SplineWeights(double t)
      : value{0.5 * (1 - t) * (1 - t), 0.5 + t * (1 - t), 0.5 * t * t}, slope{t - 1, 1 - 2 * t, t} {}
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
  /// Numbers of a leaf's coefficients; the first axis runs fastest, the leaf's own stands in the middle.
  using Local = std::array<Index, n_local>;

  /// `grid` must outlive it and must not be refined in its lifetime.
  explicit SplineSpace(const Octree<Dim>& grid);

  const Octree<Dim>& grid() const { return *grid_; }
  Index n_coefficients() const { return n_coefficients_; }
  /// What a look-up in a leaf reads.
  struct alignas(64) Leaf {
    Local coefficients;
    typename Octree<Dim>::Coord corner;  ///< in units of its side
    std::int32_t level;
  };
  /// \pre `leaf` is the number of a leaf's cell
  const Leaf& of_leaf(Index leaf) const { return leaves_[leaf]; }

  /// Coefficients of a function from its values at the nodes, hanging ones included: means over the corners
  /// of cells. The first `n_sharp` components are sharpened so that quadratic polynomials are reproduced away
  /// from coarser neighbours and from the boundary, linear ones everywhere: error of third order. The others
  /// are not, so that they stay within the range of the values around, which keeps matrices positive
  /// definite: error of second order. Row: an array of numbers.
  template <class Row>
  std::vector<Row> coefficients(std::span<const Row> nodal,
                                std::size_t n_sharp = std::tuple_size_v<Row>) const;

 private:
  struct Sampled {
    Index cell;
    std::array<Index, 2 * Dim>
        neighbours;  ///< below and above along each axis, the cell itself outside the domain
  };
  struct Derived {
    Index coefficient;
    bool outside;  ///< of the domain: 2 source[0] - source[1], or source[0] if not sharp
    std::array<Index, n_corners<Dim>> source;  ///< else of larger cells: bit k says which are on the far side
  };
  using Coord = typename Octree<Dim>::Coord;

  Local find_neighbours(int level, const Coord& corner) const;
  Index coefficient_at(int level, const Coord& corner);
  void make_cell(Index cell, const Local& neighbours);
  void derive(Index coefficient, int level, const Coord& corner);

  const Octree<Dim>* grid_;
  Index n_coefficients_;
  std::vector<Leaf> leaves_;  ///< by cell; of no meaning where that is not a leaf
  std::vector<Sampled> sampled_;
  std::vector<Derived> derived_;  ///< none before its sources
  std::vector<char> made_;        ///< by cell
  KeyMap others_;                 ///< coefficients that belong to no cell of the grid
};

template <int Dim>
template <class Row>
std::vector<Row> SplineSpace<Dim>::coefficients(std::span<const Row> nodal, std::size_t n_sharp) const {
  const auto combine = [](Row& sum, double weight, const Row& row, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) sum[i] += weight * row[i];
  };
  const std::size_t n_all = std::tuple_size_v<Row>;
  std::vector<Row> mean(static_cast<std::size_t>(grid_->n_cells()), Row{});
  parallel_for(mean.size(), [&](std::size_t c) {
    for (const Index node : grid_->cell(static_cast<Index>(c)).nodes)
      combine(mean[c], 1.0 / n_corners<Dim>, nodal[node], n_all);
  });
  std::vector<Row> result(static_cast<std::size_t>(n_coefficients_), Row{});
  parallel_for(sampled_.size(), [&](std::size_t i) {
    const Sampled& s = sampled_[i];
    Row& row = result[s.cell];
    row = mean[s.cell];
    for (int k = 0; k < Dim; ++k) {
      const Index below = s.neighbours[2 * k], above = s.neighbours[2 * k + 1];
      if (below == s.cell || above == s.cell) continue;  // continued linearly
      combine(row, 0.5, mean[s.cell], n_sharp);
      combine(row, -0.25, mean[below], n_sharp);
      combine(row, -0.25, mean[above], n_sharp);
    }
  });
  for (const Derived& d : derived_) {
    Row row{};
    if (d.outside) {
      row = result[d.source[0]];
      combine(row, 1, result[d.source[0]], n_sharp);
      combine(row, -1, result[d.source[1]], n_sharp);
    } else {
      for (int c = 0; c < n_corners<Dim>; ++c) {
        double weight = 1;
        for (int k = 0; k < Dim; ++k) weight *= (c >> k) & 1 ? 0.25 : 0.75;
        combine(row, weight, result[d.source[c]], n_all);
      }
    }
    result[d.coefficient] = row;
  }
  return result;
}

extern template class SplineSpace<2>;
extern template class SplineSpace<3>;

}  // namespace shellmatch
