#pragma once
/// \file
/// The deformation of eight elements at all points of a Gauss rule, axis by axis: what is interpolated along one axis
/// serves all points that differ along the others (sum factorisation: Orszag, J. Comput. Phys. 37, 1980). At two points
/// for each direction of space that takes 54 operations for a component, where one point after the other takes 8 times 22.

#include "energies/elements/element_batch.h"
#include "grid/fields/quadrature.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace shellmatch {

/// phi and Dphi, and sums of derivatives by them. The points are those of ShapeTable, in its order.
template <int Dim, bool WithPosition = true>
class SumFactorisedEvaluator {
  using Pack = autodiff::Pack;
  static constexpr int power(int n, int exponent) { return exponent == 0 ? 1 : n * power(n, exponent - 1); }

 public:
  explicit SumFactorisedEvaluator(const ShapeTable<Dim>& shape) : n_(shape.points_per_direction) {
    for (int i = 0; i < n_; ++i) xi_[i] = shape.points[i].xi[0];  // the first direction runs fastest
    for (int q = 0; q < power(n_, Dim); ++q)
      for (int k = 0; k < Dim; ++k) {
        const int below = power(n_, k);
        across_[q][k] = q % below + q / (below * n_) * below;
      }
  }

  /// Computes them for these elements.
  void evaluate(const ElementBatch<Dim>& batch) {
    with_count([&](auto n) { evaluate_all(n, batch); });
  }
  /// phi at a point. \pre WithPosition
  std::array<Pack, Dim> position(std::size_t q) const {
    static_assert(WithPosition);
    std::array<Pack, Dim> y;
    for (int a = 0; a < Dim; ++a) y[a] = y_[a * power(n_, Dim) + q];
    return y;
  }
  /// Dphi at a point, by rows.
  void jacobian(std::size_t q, Pack* dphi) const {
    for (int a = 0; a < Dim; ++a)
      for (int k = 0; k < Dim; ++k) dphi[a * Dim + k] = d_[a][k][across_[q][k]];
  }

  /// Forgets the sums of derivatives.
  void clear_adjoint() {
    if constexpr (WithPosition) std::fill_n(by_y_.begin(), Dim * power(n_, Dim), Pack{});
    for (auto& row : by_d_)
      for (auto& entry : row) std::fill_n(entry.begin(), power(n_, Dim - 1), Pack{});
  }
  /// Adds derivatives by phi at a point. \pre WithPosition
  void add_by_position(std::size_t q, const std::array<Pack, Dim>& by_y) {
    static_assert(WithPosition);
    for (int a = 0; a < Dim; ++a) by_y_[a * power(n_, Dim) + q] += by_y[a];
  }
  /// And by Dphi, by rows.
  void add_by_jacobian(std::size_t q, const Pack* by_dphi) {
    for (int a = 0; a < Dim; ++a)
      for (int k = 0; k < Dim; ++k) by_d_[a][k][across_[q][k]] += by_dphi[a * Dim + k];
  }
  /// The transpose of evaluate(): adds the derivatives by the nodes to those of these elements.
  void add_to_gradient(ElementBatch<Dim>& batch) const {
    with_count([&](auto n) { transpose_all(n, batch); });
  }

 private:
  /// Two points for each direction are what is minimised with, and what the compiler unrolls loops for.
  template <class Body>
  [[gnu::always_inline]] void with_count(Body&& body) const {
    if (n_ == 2)
      body(std::integral_constant<int, 2>{});
    else
      body(n_);
  }
  /// body(axis) for all, known to the compiler.
  template <class Body>
  [[gnu::always_inline]] static void for_axes(Body&& body) {
    [&]<int... Axis>(std::integer_sequence<int, Axis...>) {
      (body(std::integral_constant<int, Axis>{}), ...);
    }(std::make_integer_sequence<int, Dim>{});
  }

  // Half done, a component and its slopes are tensors of `before` entries, by points along the axes that are done, times
  // 2, by corners along the axis in hand, times `after`, by corners along those to come; what comes first runs fastest.
  static constexpr int max_half_done = 2 * power(max_gauss_points, Dim - 1);
  using HalfDone = std::array<std::array<Pack, max_half_done>, 2>;  // from one to the other
  struct Shape {
    int before, after;
    int lower(int p, int r) const { return p + before * 2 * r; }
    int upper(int p, int r) const { return p + before * (2 * r + 1); }
    int slope(int p, int r) const { return p + before * r; }
    int point(int p, int q, int n, int r) const { return p + before * (q + n * r); }
  };

  template <class Count>
  [[gnu::always_inline]] void interpolate(Shape s, Count n, const Pack* from, Pack* to) const {
    for (int r = 0; r < s.after; ++r)
      for (int p = 0; p < s.before; ++p) {
        const Pack lower = from[s.lower(p, r)], slope = from[s.upper(p, r)] - lower;
        for (int q = 0; q < n; ++q) to[s.point(p, q, n, r)] = lower + xi_[q] * slope;
      }
  }
  template <class Count>
  [[gnu::always_inline]] void transpose_of_interpolate(Shape s, Count n, const Pack* from, Pack* to) const {
    for (int r = 0; r < s.after; ++r)
      for (int p = 0; p < s.before; ++p) {
        Pack sum = from[s.point(p, 0, n, r)], upper = xi_[0] * sum;
        for (int q = 1; q < n; ++q) {
          const Pack x = from[s.point(p, q, n, r)];
          sum += x;
          upper += xi_[q] * x;
        }
        to[s.lower(p, r)] = sum - upper;
        to[s.upper(p, r)] = upper;
      }
  }

  template <class Count>
  [[gnu::always_inline]] void evaluate_all(Count n, const ElementBatch<Dim>& batch) {
    for (int a = 0; a < Dim; ++a) {
      HalfDone value;
      std::array<HalfDone, Dim> slope;
      for (int c = 0; c < n_corners<Dim>; ++c) value[0][c] = batch.u[c * Dim + a];
      for_axes([&](auto axis) {
        constexpr bool last = axis == Dim - 1;
        constexpr int from = axis % 2, to = 1 - from, after = 1 << (Dim - 1 - axis);
        const auto slope_to = [&](int k) { return last ? d_[a][k].data() : slope[k][to].data(); };
        for (int k = 0; k < axis; ++k)
          interpolate({power(n, axis - 1), after}, n, slope[k][from].data(), slope_to(k));
        const Shape s{power(n, axis), after};
        for (int r = 0; r < s.after; ++r)
          for (int p = 0; p < s.before; ++p)
            slope_to(axis)[s.slope(p, r)] =
                (value[from][s.upper(p, r)] - value[from][s.lower(p, r)]) * batch.inverse_side;
        if constexpr (!last)
          interpolate(s, n, value[from].data(), value[to].data());
        else if constexpr (WithPosition)
          interpolate(s, n, value[from].data(), y_.data() + a * power(n, Dim));
      });
    }
  }

  template <class Count>
  [[gnu::always_inline]] void transpose_all(Count n, ElementBatch<Dim>& batch) const {
    for (int a = 0; a < Dim; ++a) {
      HalfDone value;
      std::array<HalfDone, Dim> slope;
      for_axes([&](auto done) {
        constexpr int axis = Dim - 1 - done, to = axis % 2, from = 1 - to, after = 1 << (Dim - 1 - axis);
        constexpr bool last = axis == Dim - 1;
        const auto slope_from = [&](int k) { return last ? by_d_[a][k].data() : slope[k][from].data(); };
        const Shape s{power(n, axis), after};
        if constexpr (!last)
          transpose_of_interpolate(s, n, value[from].data(), value[to].data());
        else if constexpr (WithPosition)
          transpose_of_interpolate(s, n, by_y_.data() + a * power(n, Dim), value[to].data());
        else
          std::fill_n(value[to].begin(), 2 * s.before, Pack{});
        for (int r = 0; r < s.after; ++r)
          for (int p = 0; p < s.before; ++p) {
            const Pack by_difference = slope_from(axis)[s.slope(p, r)] * batch.inverse_side;
            value[to][s.lower(p, r)] -= by_difference;
            value[to][s.upper(p, r)] += by_difference;
          }
        for (int k = 0; k < axis; ++k)
          transpose_of_interpolate({power(n, axis - 1), after}, n, slope_from(k), slope[k][to].data());
      });
      for (int c = 0; c < n_corners<Dim>; ++c) batch.gradient[c * Dim + a] += value[0][c];
    }
  }

  int n_;  ///< points for each direction
  std::array<double, max_gauss_points> xi_;
  std::array<std::array<int, Dim>, power(max_gauss_points, Dim)> across_;  ///< by point: its place in d_[][k]
  std::array<Pack, WithPosition ? Dim * power(max_gauss_points, Dim) : 1> y_, by_y_;  ///< component, then point
  /// Entry (a, k) of Dphi, which is the same all along direction k: by points along the others.
  using Entry = std::array<Pack, power(max_gauss_points, Dim - 1)>;
  std::array<std::array<Entry, Dim>, Dim> d_, by_d_;
};

}  // namespace shellmatch
