#pragma once
/// \file
/// The sum over the 3^Dim coefficients of a quadratic spline (grid/fields/spline_space.h) and its derivatives, one axis
/// after the other. Rows of coefficients are vectors of numbers; T is a number, or a pack of them for as many points.

#include "grid/fields/spline_space.h"

#include <array>
#include <type_traits>

namespace shellmatch {

/// What the coefficients of a leaf are multiplied by, at t in it, for values and derivatives by y where dt/dy is `scale`.
template <int Dim, class T>
struct SplineFactors {
  using Three = std::array<T, 3>;
  std::array<Three, Dim> value, slope;  ///< along each axis

  SplineFactors(const std::array<T, Dim>& t, const std::array<T, Dim>& scale) {
    for (int k = 0; k < Dim; ++k) {
      const SplineWeights<T> w(t[k]);
      value[k] = w.value;
      for (int i = 0; i < 3; ++i) slope[k][i] = w.slope[i] * scale[k];
    }
  }
};

namespace detail {

template <class Row, class Weights, class Pick>
Row along(const Weights& weights, Pick&& pick, const std::array<Row, 3>& rows) {
  return pick(weights[0]) * rows[0] + pick(weights[1]) * rows[1] + pick(weights[2]) * rows[2];
}

}  // namespace detail

/// What was derived along an axis is interpolated along those that follow. Written so that few rows are alive at a
/// time. at(n): row of coefficient n. pick(x): of a T what the rows of this sum are to be multiplied by. put(0, value),
/// then put(1 + k, derivative by axis k).
template <int Dim, bool WithGradient, class T, class At, class Pick, class Put>
inline void sum_spline(const SplineFactors<Dim, T>& f, At&& at, Pick&& pick, Put&& put) {
  using Row = std::remove_cvref_t<decltype(at(0))>;
  constexpr int n_slices = Dim == 3 ? 3 : 1;
  using detail::along;
  std::array<Row, n_slices> v, dx, dy;
  for (int z = 0; z < n_slices; ++z) {
    std::array<Row, 3> vy, dxy;
    for (int j = 0; j < 3; ++j) {
      const std::array<Row, 3> rows{at(9 * z + 3 * j), at(9 * z + 3 * j + 1), at(9 * z + 3 * j + 2)};
      vy[j] = along(f.value[0], pick, rows);
      if (WithGradient) dxy[j] = along(f.slope[0], pick, rows);
    }
    v[z] = along(f.value[1], pick, vy);
    if (WithGradient) {
      dx[z] = along(f.value[1], pick, dxy);
      dy[z] = along(f.slope[1], pick, vy);
    }
  }
  if constexpr (Dim == 2) {
    put(0, v[0]);
    if (WithGradient) {
      put(1, dx[0]);
      put(2, dy[0]);
    }
  } else {
    put(0, along(f.value[2], pick, v));
    if (WithGradient) {
      put(1, along(f.value[2], pick, dx));
      put(2, along(f.value[2], pick, dy));
      put(3, along(f.slope[2], pick, v));
    }
  }
}

}  // namespace shellmatch
