#pragma once
/// \file
/// An order of points in which those near each other follow one another.

#include "base/types.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace shellmatch {

/// Number of a point of the unit cube along a Morton curve: points that are close on the curve are close in space.
template <int Dim>
std::uint64_t morton_number(const Vec<Dim>& x) {
  std::uint64_t number = 0;
  constexpr int bits = 60 / Dim;
  for (int k = 0; k < Dim; ++k) {
    const auto coordinate = static_cast<std::uint64_t>(std::clamp(x[k], 0.0, 1.0) * ((std::uint64_t{1} << bits) - 1));
    for (int bit = 0; bit < bits; ++bit) number |= ((coordinate >> bit) & 1) << (bit * Dim + k);
  }
  return number;
}

/// The points along a Morton curve through their box. Where there are points that are not finite, as they stand.
template <int Dim>
std::vector<Index> along_morton_curve(std::span<const Vec<Dim>> points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  if (points.empty()) return order;
  Vec<Dim> low = points[0], high = points[0];
  bool is_finite = true;
  for (const Vec<Dim>& x : points) {
    is_finite &= x.allFinite();
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double side = (high - low).maxCoeff();
  if (!is_finite || !(side > 0) || !std::isfinite(side)) return order;
  std::vector<std::pair<std::uint64_t, Index>> numbers(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    numbers[i] = {morton_number<Dim>((points[i] - low) / side), static_cast<Index>(i)};
  std::ranges::sort(numbers);
  for (std::size_t i = 0; i < points.size(); ++i) order[i] = numbers[i].second;
  return order;
}

}  // namespace shellmatch
