#pragma once
/// \file
/// The template shape as the energies see it: d2, n2 and C(S2)^{1/2}, known at the nodes and looked up at
/// deformed positions. The one place where a coefficient depends on phi.

#include "energies/autodiff/jet.h"
#include "energies/integrands.h"
#include "grid/octree.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

/// Multilinear interpolation of the template's nodal fields. Positions outside the domain are projected onto it
/// first (paper, section 6); the derivative in a projected direction is zero.
template <int Dim>
class TargetField {
 public:
  static constexpr int n_values = TargetPoint<Dim, double>::size;
  /// Values per node, padded to whole vectors of four.
  static constexpr int row_size = (n_values + 3) / 4 * 4;
  using Quad = double __attribute__((vector_size(32)));
  using Row = std::array<Quad, row_size / 4>;

  /// Nodal fields, hanging nodes included; keeps a copy. `grid` must outlive this object.
  TargetField(const Octree<Dim>& grid, std::span<const double> distance, std::span<const Vec<Dim>> normal,
              std::span<const std::array<double, n_symmetric<Dim>>> root);

  /// Values in the order of TargetPoint: d2, n2, root.
  Row value(const Vec<Dim>& y) const;

  /// The same with the derivative by each coordinate of y.
  Row value(const Vec<Dim>& y, std::array<Row, Dim>& derivative) const;

  /// For any scalar, ceres::Jet among them: the derivative comes from the scalar's own arithmetic.
  template <class T>
  TargetPoint<Dim, T> at(SmallVec<T, Dim> y) const;

  const Octree<Dim>& grid() const { return *grid_; }

 private:
  const Octree<Dim>* grid_;
  std::vector<Row> rows_;
};

template <int Dim>
inline typename TargetField<Dim>::Row TargetField<Dim>::value(const Vec<Dim>& y, std::array<Row, Dim>& derivative) const {
  const Vec<Dim> inside = y.cwiseMax(0.0).cwiseMin(1.0);
  const auto& cell = grid_->cell(grid_->locate(inside));
  const double scale = static_cast<double>(1 << cell.level);
  std::array<double, Dim> xi, slope;
  for (int k = 0; k < Dim; ++k) {
    xi[k] = inside[k] * scale - cell.corner[k];
    slope[k] = inside[k] == y[k] ? scale : 0.0;
  }
  // Collapse one axis after the other: differences give the derivative along the axis, which is then
  // interpolated along the axes that follow.
  constexpr int n = n_corners<Dim>;
  std::array<Row, n> v;
  for (int c = 0; c < n; ++c) v[c] = rows_[cell.nodes[c]];
  std::array<std::array<Row, n / 2>, Dim> d;
  for (int k = 0, left = n / 2; k < Dim; ++k, left /= 2) {
    for (int j = 0; j < k; ++j)
      for (int i = 0; i < left; ++i)
        for (std::size_t s = 0; s < v[0].size(); ++s) d[j][i][s] = d[j][2 * i][s] + xi[k] * (d[j][2 * i + 1][s] - d[j][2 * i][s]);
    for (int i = 0; i < left; ++i)
      for (std::size_t s = 0; s < v[0].size(); ++s) {
        const Quad difference = v[2 * i + 1][s] - v[2 * i][s];
        d[k][i][s] = slope[k] * difference;
        v[i][s] = v[2 * i][s] + xi[k] * difference;
      }
  }
  for (int k = 0; k < Dim; ++k) derivative[k] = d[k][0];
  return v[0];
}

template <int Dim>
inline typename TargetField<Dim>::Row TargetField<Dim>::value(const Vec<Dim>& y) const {
  const Vec<Dim> inside = y.cwiseMax(0.0).cwiseMin(1.0);
  const auto& cell = grid_->cell(grid_->locate(inside));
  const double scale = static_cast<double>(1 << cell.level);
  constexpr int n = n_corners<Dim>;
  std::array<Row, n> v;
  for (int c = 0; c < n; ++c) v[c] = rows_[cell.nodes[c]];
  for (int k = 0, left = n / 2; k < Dim; ++k, left /= 2) {
    const double xi = inside[k] * scale - cell.corner[k];
    for (int i = 0; i < left; ++i)
      for (std::size_t s = 0; s < v[0].size(); ++s) v[i][s] = v[2 * i][s] + xi * (v[2 * i + 1][s] - v[2 * i][s]);
  }
  return v[0];
}

template <int Dim>
template <class T>
TargetPoint<Dim, T> TargetField<Dim>::at(SmallVec<T, Dim> y) const {
  Vec<Dim> place;
  for (int k = 0; k < Dim; ++k) {
    if (autodiff::scalar_part(y[k]) < 0) y[k] = T(0.0);
    if (autodiff::scalar_part(y[k]) > 1) y[k] = T(1.0);
    place[k] = autodiff::scalar_part(y[k]);
  }
  const auto& cell = grid_->cell(grid_->locate(place));
  const double scale = static_cast<double>(1 << cell.level);
  std::array<T, n_values> sum;
  sum.fill(T(0.0));
  for (int c = 0; c < n_corners<Dim>; ++c) {
    T weight(1.0);
    for (int k = 0; k < Dim; ++k) {
      const T xi = y[k] * scale - static_cast<double>(cell.corner[k]);
      weight = weight * ((c >> k) & 1 ? xi : 1.0 - xi);
    }
    const Row& row = rows_[cell.nodes[c]];
    for (int i = 0; i < n_values; ++i) sum[i] += weight * row[i / 4][i % 4];
  }
  TargetPoint<Dim, T> p;
  p.d2 = sum[0];
  for (int i = 0; i < Dim; ++i) p.n2[i] = sum[1 + i];
  for (int i = 0; i < n_symmetric<Dim>; ++i) p.root.v[i] = sum[1 + Dim + i];
  return p;
}

}  // namespace shellmatch
