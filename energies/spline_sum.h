#pragma once
/// \file
/// The sum over the 3^Dim coefficients of a quadratic spline (grid/spline_space.h) and its derivatives, one axis
/// after the other. Rows of coefficients are vectors of numbers; T is a number, or a pack of them for as many points.

#include "grid/spline_space.h"

#include <array>
#include <type_traits>

namespace shellmatch {

/// What the coefficients of a leaf are multiplied by, at t in it, for values and derivatives by y where dt/dy is `scale`.
template <int Dim, class T>
struct SplineFactors {
  using Three = std::array<T, 3>;
  std::array<T, Dim> t;
  std::array<Three, Dim> value, slope;  ///< along each axis
  /// Along the last axis if those before it were summed by differences: for the value, for the derivative by each axis.
  std::array<Three, Dim + 1> last;

  SplineFactors(const std::array<T, Dim>& place, const std::array<T, Dim>& scale) : t(place) {
    for (int k = 0; k < Dim; ++k) {
      const SplineWeights<T> w(t[k]);
      value[k] = w.value;
      for (int i = 0; i < 3; ++i) slope[k][i] = w.slope[i] * scale[k];
    }
    // Each axis that was summed to twice the value is put right.
    constexpr double before = Dim == 3 ? 0.25 : 0.5;
    for (int i = 0; i < 3; ++i) {
      last[0][i] = before * value[Dim - 1][i];
      for (int k = 0; k < Dim - 1; ++k) last[1 + k][i] = (k == 0 ? 1.0 : 0.5) * scale[k] * value[Dim - 1][i];
      last[Dim][i] = before * slope[Dim - 1][i];
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

/// The same with derivatives, by differences of rows, which are added while others are multiplied: for rows as long as
/// a register, where sum_spline() waits for the multipliers and the adders idle.
template <int Dim, class T, class At, class Pick, class Put>
inline void sum_spline_by_differences(const SplineFactors<Dim, T>& f, At&& at, Pick&& pick, Put&& put) {
  using Row = std::remove_cvref_t<decltype(at(0))>;
  using detail::along;
  const auto twice_and_slope = [&](int k, const Row& a, const Row& b, const Row& c, Row& twice, Row& slope) {
    const auto t = pick(f.t[k]);
    const Row first = b - a, sum = a + b;
    const Row second = (a + c) - 2.0 * b;
    slope = first + t * second;
    twice = sum + t * (first + slope);
  };
  std::array<Row, 3> v, dx, dy;
  for (int z = 0; z < (Dim == 3 ? 3 : 1); ++z) {
    std::array<Row, 3> vy, dxy;
    for (int j = 0; j < 3; ++j)
      twice_and_slope(0, at(9 * z + 3 * j), at(9 * z + 3 * j + 1), at(9 * z + 3 * j + 2), vy[j], dxy[j]);
    if constexpr (Dim == 2) {
      v = vy;
      dx = dxy;
    } else {
      twice_and_slope(1, vy[0], vy[1], vy[2], v[z], dy[z]);
      dx[z] = along(f.value[1], pick, dxy);
    }
  }
  put(0, along(f.last[0], pick, v));
  put(1, along(f.last[1], pick, dx));
  if constexpr (Dim == 3) put(2, along(f.last[2], pick, dy));
  put(Dim, along(f.last[Dim], pick, v));
}

/// Whichever of both is the faster for rows as long as a register.
template <int Dim, bool WithGradient, class T, class At, class Pick, class Put>
inline void sum_long_rows(const SplineFactors<Dim, T>& f, At&& at, Pick&& pick, Put&& put) {
  if constexpr (WithGradient)
    sum_spline_by_differences<Dim>(f, at, pick, put);
  else
    sum_spline<Dim, false>(f, at, pick, put);
}

}  // namespace shellmatch
