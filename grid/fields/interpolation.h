#pragma once
/// \file
/// Multilinear shape functions on a cell, and the interpolation of nodal fields.

#include "grid/octree/octree.h"

#include <array>
#include <span>

namespace shellmatch {

/// A point of a leaf: x = cell_corner + side * xi.
template <int Dim>
struct LocalPoint {
  Index cell;
  Vec<Dim> xi;  ///< in [0, 1]^Dim
};

/// The leaf that contains x, and the local coordinates of x in it. x outside the domain is projected onto it
/// first.
template <int Dim>
LocalPoint<Dim> locate_local(const Octree<Dim>& grid, const Vec<Dim>& x) {
  const Vec<Dim> inside = x.cwiseMax(0.0).cwiseMin(1.0);
  LocalPoint<Dim> p;
  p.cell = grid.locate(inside);
  const auto& cell = grid.cell(p.cell);
  const double per_side = static_cast<double>(1 << cell.level);
  for (int k = 0; k < Dim; ++k) p.xi[k] = inside[k] * per_side - cell.corner[k];
  return p;
}

/// Values of the corners' shape functions at xi. They are non-negative and their sum is 1.
template <int Dim>
std::array<double, n_corners<Dim>> shape_values(const Vec<Dim>& xi) {
  std::array<double, n_corners<Dim>> w;
  w[0] = 1;
  for (int k = 0; k < Dim; ++k)
    for (int c = 0; c < (1 << k); ++c) {
      w[c | (1 << k)] = w[c] * xi[k];
      w[c] *= 1 - xi[k];
    }
  return w;
}

/// Gradients of the shape functions with respect to xi; their sum is 0. Divide by the cell's side for those
/// in x.
template <int Dim>
std::array<Vec<Dim>, n_corners<Dim>> shape_gradients(const Vec<Dim>& xi) {
  std::array<Vec<Dim>, n_corners<Dim>> g;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int i = 0; i < Dim; ++i) {
      double v = (c >> i) & 1 ? 1 : -1;
      for (int k = 0; k < Dim; ++k)
        if (k != i) v *= (c >> k) & 1 ? xi[k] : 1 - xi[k];
      g[c][i] = v;
    }
  return g;
}

/// Value at p of a nodal field of scalars, vectors or packed symmetric matrices. \pre hanging nodes are set
template <int Dim, class T>
T evaluate(const Octree<Dim>& grid, const std::vector<T>& nodal, const LocalPoint<Dim>& p) {
  const auto w = shape_values<Dim>(p.xi);
  const auto& nodes = grid.cell(p.cell).nodes;
  T value = w[0] * nodal[nodes[0]];
  for (int c = 1; c < n_corners<Dim>; ++c) value += w[c] * nodal[nodes[c]];
  return value;
}

template <int Dim, class T>
T evaluate(const Octree<Dim>& grid, const std::vector<T>& nodal, const Vec<Dim>& x) {
  return evaluate(grid, nodal, locate_local(grid, x));
}

/// The same for a field of `Components` doubles per node, stored node by node.
template <int Components, int Dim>
std::array<double, Components> evaluate_components(const Octree<Dim>& grid, std::span<const double> nodal,
                                                   const LocalPoint<Dim>& p) {
  const auto w = shape_values<Dim>(p.xi);
  const auto& nodes = grid.cell(p.cell).nodes;
  std::array<double, Components> value{};
  for (int c = 0; c < n_corners<Dim>; ++c) {
    const double* at_node = nodal.data() + static_cast<std::size_t>(Components) * nodes[c];
    for (int i = 0; i < Components; ++i) value[i] += w[c] * at_node[i];
  }
  return value;
}

/// Gradient with respect to x of a scalar field at p; on a face of p.cell, its limit from inside the cell.
template <int Dim>
Vec<Dim> evaluate_gradient(const Octree<Dim>& grid, const std::vector<double>& nodal, const LocalPoint<Dim>& p) {
  const auto g = shape_gradients<Dim>(p.xi);
  const auto& cell = grid.cell(p.cell);
  Vec<Dim> sum = Vec<Dim>::Zero();
  for (int c = 0; c < n_corners<Dim>; ++c) sum += nodal[cell.nodes[c]] * g[c];
  return sum * static_cast<double>(1 << cell.level);
}

/// Derivative with respect to x of a vector field: entry (i, j) is that of component i along axis j.
template <int Dim>
Mat<Dim> evaluate_gradient(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& nodal, const LocalPoint<Dim>& p) {
  const auto g = shape_gradients<Dim>(p.xi);
  const auto& cell = grid.cell(p.cell);
  Mat<Dim> sum = Mat<Dim>::Zero();
  for (int c = 0; c < n_corners<Dim>; ++c) sum += nodal[cell.nodes[c]] * g[c].transpose();
  return sum * static_cast<double>(1 << cell.level);
}

}  // namespace shellmatch
