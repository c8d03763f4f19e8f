#pragma once
/// \file
/// The deformation of eight elements and its derivatives at all points of a tensor Gauss rule, by sum factorisation
/// (Orszag, J. Comput. Phys. 37, 1980): the tensor of nodal values is contracted with the one-dimensional shape
/// functions axis by axis. In space, with two points per axis, a component takes 54 operations, as against 22 for
/// each of 8 points.

#include "energies/elements/element_batch.h"
#include "grid/fields/quadrature.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace shellmatch {

/// Values of phi and Dphi at the points, and adjoints: the derivatives of an energy by them. Point q is
/// ShapeTable::points[q]. Dphi is stored row after row: entry a * Dim + k is the derivative of component a along axis
/// k.
template <int Dim, bool WithPosition = true>
class SumFactorisedEvaluator {
  using Pack = autodiff::Pack;
  static constexpr int power(int n, int exponent) { return exponent == 0 ? 1 : n * power(n, exponent - 1); }

 public:
  explicit SumFactorisedEvaluator(const ShapeTable<Dim>& shape) : n_(shape.points_per_direction) {
    for (int i = 0; i < n_; ++i) xi_[i] = shape.points[i].xi[0];  // the first direction runs fastest
    for (int q = 0; q < power(n_, Dim); ++q)
      for (int k = 0; k < Dim; ++k) {
        const int stride = power(n_, k);  // of axis k in the numbering of the points
        face_point_[q][k] = q % stride + q / (stride * n_) * stride;
      }
  }

  /// Computes phi (if WithPosition) and Dphi at all points of these elements.
  void evaluate(const ElementBatch<Dim>& batch) {
    with_count([&](auto n) { evaluate_all(n, batch); });
  }
  /// phi at point q.
  std::array<Pack, Dim> position(std::size_t q) const {
    static_assert(WithPosition);
    std::array<Pack, Dim> y;
    for (int a = 0; a < Dim; ++a) y[a] = y_[a * power(n_, Dim) + q];
    return y;
  }
  /// Writes Dphi at point q.
  void jacobian(std::size_t q, Pack* dphi) const {
    for (int a = 0; a < Dim; ++a)
      for (int k = 0; k < Dim; ++k) dphi[a * Dim + k] = d_[a][k][face_point_[q][k]];
  }

  /// Sets the adjoints to zero.
  void clear_adjoint() {
    if constexpr (WithPosition) std::fill_n(by_y_.begin(), Dim * power(n_, Dim), Pack{});
    for (auto& row : by_d_)
      for (auto& entry : row) std::fill_n(entry.begin(), power(n_, Dim - 1), Pack{});
  }
  /// Adds the derivative by phi at point q.
  void add_by_position(std::size_t q, const std::array<Pack, Dim>& by_y) {
    static_assert(WithPosition);
    for (int a = 0; a < Dim; ++a) by_y_[a * power(n_, Dim) + q] += by_y[a];
  }
  /// Adds the derivative by Dphi at point q.
  void add_by_jacobian(std::size_t q, const Pack* by_dphi) {
    for (int a = 0; a < Dim; ++a)
      for (int k = 0; k < Dim; ++k) by_d_[a][k][face_point_[q][k]] += by_dphi[a * Dim + k];
  }
  /// The transpose of evaluate(): adds the derivatives by the nodal positions to the gradients of these elements.
  void add_to_gradient(ElementBatch<Dim>& batch) const {
    with_count([&](auto n) { transpose_all(n, batch); });
  }

 private:
  /// Calls body(n_). Two points per axis, the default rule, are a compile-time constant, so that loops are unrolled.
  [[gnu::always_inline]] void with_count(auto&& body) const {
    if (n_ == 2) body(std::integral_constant<int, 2>{});
    else body(n_);
  }
  /// Calls body(axis) for all axes, each a compile-time constant.
  [[gnu::always_inline]] static void for_axes(auto&& body) {
    [&]<int... Axis>(std::integer_sequence<int, Axis...>) { (body(std::integral_constant<int, Axis>{}), ...); }
    (std::make_integer_sequence<int, Dim>{});
  }

  /// A partially contracted tensor: one index over the points along the axes that are contracted, one over the 2
  /// corners along the axis to contract next, one over the corners along the remaining axes. The first index runs
  /// fastest.
  static constexpr int max_partial_size = 2 * power(max_gauss_points, Dim - 1);
  using PartialTensor = std::array<std::array<Pack, max_partial_size>, 2>;  // source and destination of a contraction
  /// Extents of the first and the last index, and the offset of an entry before and after the contraction.
  struct Extents {
    int points, corners;
    int lower(int p, int r) const { return p + points * 2 * r; }
    int upper(int p, int r) const { return p + points * (2 * r + 1); }
    int derivative(int p, int r) const { return p + points * r; }
    int point(int p, int q, int n, int r) const { return p + points * (q + n * r); }
  };

  /// Contracts with the shape functions 1 - xi and xi at the n points along one axis.
  template <class Count>
  [[gnu::always_inline]] void interpolate(Extents e, Count n, const Pack* from, Pack* to) const {
    for (int r = 0; r < e.corners; ++r)
      for (int p = 0; p < e.points; ++p) {
        const Pack lower = from[e.lower(p, r)], difference = from[e.upper(p, r)] - lower;
        for (int q = 0; q < n; ++q) to[e.point(p, q, n, r)] = lower + xi_[q] * difference;
      }
  }
  template <class Count>
  [[gnu::always_inline]] void transpose_of_interpolate(Extents e, Count n, const Pack* from, Pack* to) const {
    for (int r = 0; r < e.corners; ++r)
      for (int p = 0; p < e.points; ++p) {
        Pack sum = from[e.point(p, 0, n, r)], upper = xi_[0] * sum;
        for (int q = 1; q < n; ++q) {
          const Pack x = from[e.point(p, q, n, r)];
          sum += x;
          upper += xi_[q] * x;
        }
        to[e.lower(p, r)] = sum - upper;
        to[e.upper(p, r)] = upper;
      }
  }

  template <class Count>
  [[gnu::always_inline]] void evaluate_all(Count n, const ElementBatch<Dim>& batch) {
    for (int a = 0; a < Dim; ++a) {
      PartialTensor value;
      std::array<PartialTensor, Dim> derivative;
      for (int c = 0; c < n_corners<Dim>; ++c) value[0][c] = batch.u[c * Dim + a];
      for_axes([&](auto axis) {
        constexpr bool last = axis == Dim - 1;
        constexpr int from = axis % 2, to = 1 - from, corners = 1 << (Dim - 1 - axis);
        const auto derivative_to = [&](int k) { return last ? d_[a][k].data() : derivative[k][to].data(); };
        for (int k = 0; k < axis; ++k)
          interpolate({power(n, axis - 1), corners}, n, derivative[k][from].data(), derivative_to(k));
        const Extents e{power(n, axis), corners};
        for (int r = 0; r < e.corners; ++r)
          for (int p = 0; p < e.points; ++p)
            derivative_to(axis)[e.derivative(p, r)] =
                (value[from][e.upper(p, r)] - value[from][e.lower(p, r)]) * batch.inverse_side;
        if constexpr (!last) interpolate(e, n, value[from].data(), value[to].data());
        else if constexpr (WithPosition) interpolate(e, n, value[from].data(), y_.data() + a * power(n, Dim));
      });
    }
  }

  template <class Count>
  [[gnu::always_inline]] void transpose_all(Count n, ElementBatch<Dim>& batch) const {
    for (int a = 0; a < Dim; ++a) {
      PartialTensor value;
      std::array<PartialTensor, Dim> derivative;
      for_axes([&](auto step) {
        constexpr int axis = Dim - 1 - step, to = axis % 2, from = 1 - to, corners = 1 << (Dim - 1 - axis);
        constexpr bool last = axis == Dim - 1;
        const auto derivative_from = [&](int k) { return last ? by_d_[a][k].data() : derivative[k][from].data(); };
        const Extents e{power(n, axis), corners};
        if constexpr (!last) transpose_of_interpolate(e, n, value[from].data(), value[to].data());
        else if constexpr (WithPosition)
          transpose_of_interpolate(e, n, by_y_.data() + a * power(n, Dim), value[to].data());
        else std::fill_n(value[to].begin(), 2 * e.points, Pack{});
        for (int r = 0; r < e.corners; ++r)
          for (int p = 0; p < e.points; ++p) {
            const Pack by_difference = derivative_from(axis)[e.derivative(p, r)] * batch.inverse_side;
            value[to][e.lower(p, r)] -= by_difference;
            value[to][e.upper(p, r)] += by_difference;
          }
        for (int k = 0; k < axis; ++k)
          transpose_of_interpolate({power(n, axis - 1), corners}, n, derivative_from(k), derivative[k][to].data());
      });
      for (int c = 0; c < n_corners<Dim>; ++c) batch.gradient[c * Dim + a] += value[0][c];
    }
  }

  int n_;                                    ///< points per axis
  std::array<double, max_gauss_points> xi_;  ///< their coordinates on [0, 1]
  /// By point q and axis k: index of its projection along axis k among the points of the face transversal to that
  /// axis.
  std::array<std::array<int, Dim>, power(max_gauss_points, Dim)> face_point_;
  /// phi and its adjoint: component, then point.
  std::array<Pack, WithPosition ? Dim * power(max_gauss_points, Dim) : 1> y_, by_y_;
  /// Entry (a, k) of Dphi, which is constant along axis k: by points of the face transversal to it.
  using Entry = std::array<Pack, power(max_gauss_points, Dim - 1)>;
  std::array<std::array<Entry, Dim>, Dim> d_, by_d_;  ///< Dphi and its adjoint
};

}  // namespace shellmatch
