#pragma once
/// \file
/// The sum over the 3^Dim coefficients of a quadratic spline (grid/spline_space.h) and its derivatives.

#include <array>
#include <type_traits>

namespace shellmatch {

/// Collapses one axis after the other: what was derived along an axis is interpolated along those that follow.
/// Written so that few rows are alive at a time. at(n): row of coefficient n, a vector of numbers. value_of(k, i),
/// slope_of(k, i): weight of the three coefficients along axis k, and its derivative, numbers or such vectors.
/// put(0, value), then put(1 + k, derivative by axis k).
template <int Dim, bool WithGradient, class At, class Value, class Slope, class Put>
inline void sum_spline(At&& at, Value&& value_of, Slope&& slope_of, Put&& put) {
  using Part = std::remove_cvref_t<decltype(at(0))>;
  constexpr int n_slices = Dim == 3 ? 3 : 1;
  const auto along = [](auto&& weight_of, int k, const auto& rows) -> Part {
    return weight_of(k, 0) * rows[0] + weight_of(k, 1) * rows[1] + weight_of(k, 2) * rows[2];
  };
  std::array<Part, n_slices> v, dx, dy;
  for (int z = 0; z < n_slices; ++z) {
    std::array<Part, 3> vy, dxy;
    for (int j = 0; j < 3; ++j) {
      const std::array<Part, 3> rows{at(9 * z + 3 * j), at(9 * z + 3 * j + 1), at(9 * z + 3 * j + 2)};
      vy[j] = along(value_of, 0, rows);
      if (WithGradient) dxy[j] = along(slope_of, 0, rows);
    }
    v[z] = along(value_of, 1, vy);
    if (WithGradient) {
      dx[z] = along(value_of, 1, dxy);
      dy[z] = along(slope_of, 1, vy);
    }
  }
  if constexpr (Dim == 2) {
    put(0, v[0]);
    if (WithGradient) {
      put(1, dx[0]);
      put(2, dy[0]);
    }
  } else {
    put(0, along(value_of, 2, v));
    if (WithGradient) {
      put(1, along(value_of, 2, dx));
      put(2, along(value_of, 2, dy));
      put(3, along(slope_of, 2, v));
    }
  }
}

}  // namespace shellmatch
