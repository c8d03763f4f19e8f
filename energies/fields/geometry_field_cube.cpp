// Interpolation of a shape's fields at all points of a tensor grid in a cube.

#include "energies/autodiff/transpose.h"
#include "energies/fields/geometry_field.h"

#include <algorithm>

namespace shellmatch {

namespace {

/// Sums a quadratic spline at the points of a tensor grid, axis by axis. A row holds several functions.
/// \param row row(n) is that of coefficient n, the first axis fastest
/// \param weights by axis and point
/// \param result one row for each point, the first axis fastest
template <int Dim, class Row, class RowOf>
void sum_on_grid(const std::array<std::array<std::array<double, 3>, max_gauss_points>, Dim>& weights, std::size_t n,
                 RowOf&& row, Row* result) {
  constexpr std::size_t n_planes = Dim == 3 ? 3 : 1, m = max_gauss_points;
  const auto along = [](const std::array<double, 3>& w, const Row& a, const Row& b, const Row& c) {
    return w[0] * a + w[1] * b + w[2] * c;
  };
  std::array<std::array<Row, m * m>, n_planes> planes;
  for (std::size_t z = 0; z < n_planes; ++z) {
    std::array<std::array<Row, m>, 3> lines;
    for (std::size_t y = 0; y < 3; ++y) {
      const int first = static_cast<int>(9 * z + 3 * y);
      const Row a = row(first), b = row(first + 1), c = row(first + 2);
      for (std::size_t i = 0; i < n; ++i) lines[y][i] = along(weights[0][i], a, b, c);
    }
    Row* plane = Dim == 2 ? result : planes[z].data();
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        plane[j * n + i] = along(weights[1][j], lines[0][i], lines[1][i], lines[2][i]);
  }
  if constexpr (Dim == 3)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n * n; ++i)
        result[k * n * n + i] = along(weights[2][k], planes[0][i], planes[1][i], planes[2][i]);
}

}  // namespace

template <int Dim>
bool GeometryField<Dim>::look_up_cube(const Vec<Dim>& corner, double side, std::span<const double> at,
                                      std::span<Packs> values) const {
  if (!is_smooth()) return false;
  const Index leaf = splines_->locate(corner + Vec<Dim>::Constant(0.5 * side));
  const double scale = static_cast<double>(1 << splines_->level_of(leaf));
  if (side * scale > 1) return false;
  const auto leaf_corner = splines_->corner_of(leaf);
  const std::size_t n = at.size();
  std::array<std::array<std::array<double, 3>, max_gauss_points>, Dim> weights;
  std::size_t n_points = 1;
  for (int k = 0; k < Dim; ++k) {
    n_points *= n;
    for (std::size_t i = 0; i < n; ++i)
      weights[k][i] =
          SplineWeights<double>((corner[k] + side * at[i]) * scale - static_cast<double>(leaf_corner[k])).value;
  }
  const auto local = splines_->coefficients_of(leaf);
  constexpr std::size_t lanes = autodiff::pack_size;
  constexpr std::size_t most = (Dim == 2 ? 1 : max_gauss_points) * max_gauss_points * max_gauss_points;
  constexpr std::size_t n_main = std::min<std::size_t>(n_values, lanes);
  std::array<Pack, most> main;
  sum_on_grid<Dim>(
      weights, n, [&](int c) { return widened((*main_)[static_cast<std::size_t>(local[c])]); }, main.data());
  for (std::size_t p = 0; p < values.size(); ++p) {
    std::array<Pack, lanes> rows;  // by point; the last one fills up
    for (std::size_t lane = 0; lane < lanes; ++lane) rows[lane] = main[std::min(p * lanes + lane, n_points - 1)];
    autodiff::transpose(rows);
    std::copy_n(rows.begin(), n_main, values[p].begin());
  }
  if constexpr (n_rest > 0) {
    std::array<Pair, most> rest;
    sum_on_grid<Dim>(
        weights, n, [&](int c) { return widened((*rest_)[static_cast<std::size_t>(local[c])]); }, rest.data());
    for (std::size_t i = 0; i < values.size() * lanes; ++i)
      for (std::size_t r = 0; r < n_rest; ++r)
        values[i / lanes][n_main + r][i % lanes] = rest[std::min(i, n_points - 1)][r];
  }
  return true;
}

template bool GeometryField<2>::look_up_cube(const Vec<2>&, double, std::span<const double>, std::span<Packs>) const;
template bool GeometryField<3>::look_up_cube(const Vec<3>&, double, std::span<const double>, std::span<Packs>) const;

}  // namespace shellmatch
