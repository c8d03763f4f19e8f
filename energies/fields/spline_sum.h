#pragma once
/// \file
/// The sum over the 3^Dim coefficients of a quadratic spline (grid/fields/spline_space.h) and its derivatives, one axis
/// after the other. A row of coefficients is a vector of numbers; T is double, or a pack with one entry for each point.

#include "grid/fields/spline_space.h"

#include <array>
#include <type_traits>

namespace shellmatch {

/// Factors of a leaf's coefficients along each axis, for the value and, where dt/dy = `scale`, the derivatives at t in
/// the leaf.
template <int Dim, class T>
struct SplineFactors {
  using Three = std::array<T, 3>;
  std::array<Three, Dim> value, slope;  ///< by axis: weights of the value and of the derivative

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

/// Sums along x, then y, then z; a derivative along one axis is interpolated along the later ones. Few rows are alive
/// at a time, so that they stay in registers.
/// \param at at(n) is the row of coefficient n
/// \param pick pick(x) selects from a T the factor for this sum, for instance one lane
/// \param put called as put(0, value) and put(1 + k, derivative by axis k)
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
