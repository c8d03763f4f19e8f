#pragma once
/// \file
/// Outlines in the plane with one limb, whose direction differs too much for a matching to find by itself.

#include "geometry/repair/make_shape.h"

#include <cmath>
#include <numbers>

namespace shellmatch::testing {

/// Distance from the origin of the outline with a limb in direction `of_limb`, in radians.
inline double limb_radius(double angle, double of_limb) {
  const double away = std::remainder(angle - of_limb, 2 * std::numbers::pi);
  return 1 + 1.2 * std::exp(-std::pow(away / 0.25, 2));
}

inline Vec<2> limb_point(double angle, double of_limb) {
  return limb_radius(angle, of_limb) * Vec<2>(std::cos(angle), std::sin(angle));
}

/// A disk of radius 1 with a limb that reaches 2.2 from its centre.
inline Shape<2> with_limb(double of_limb) {
  constexpr int n = 400;
  OriginalShape<2> outline;
  outline.polygons.emplace_back();
  for (int i = 0; i < n; ++i) {
    outline.vertices.push_back(limb_point(2 * std::numbers::pi * i / n, of_limb));
    outline.polygons[0].push_back(i);
  }
  return make_shape(std::move(outline), "limb");
}

}  // namespace shellmatch::testing
