#pragma once
/// \file
/// Shapes whose pictures are known.

#include "geometry/surface/surface.h"

#include <cmath>
#include <numbers>

namespace shellmatch::testing {

/// A sphere of n_around times n_around / 2 quadrilaterals, each split in two.
inline Surface<3> sphere(int n_around, double radius, const Vec<3>& centre = Vec<3>::Zero()) {
  Surface<3> s;
  const int n_rings = n_around / 2;
  for (int j = 0; j <= n_rings; ++j)
    for (int i = 0; i < n_around; ++i) {
      const double a = 2 * std::numbers::pi * i / n_around, b = std::numbers::pi * j / n_rings;
      s.vertices.push_back(centre +
                           radius * Vec<3>(std::sin(b) * std::cos(a), std::cos(b), -std::sin(b) * std::sin(a)));
    }
  const auto at = [&](int i, int j) { return static_cast<Index>(j * n_around + i % n_around); };
  for (int j = 0; j < n_rings; ++j)
    for (int i = 0; i < n_around; ++i) {
      if (j > 0) s.facets.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      if (j + 1 < n_rings) s.facets.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  return s;
}

/// The cube [-1/2, 1/2]^3 times `side`, twelve triangles on eight shared vertices.
inline Surface<3> cube(double side) {
  Surface<3> s;
  for (int c = 0; c < 8; ++c) s.vertices.push_back(side * Vec<3>((c & 1) - 0.5, ((c >> 1) & 1) - 0.5, (c >> 2) - 0.5));
  for (const auto& [a, b, c, d] :
       {std::array<Index, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    s.facets.push_back({a, b, c});
    s.facets.push_back({a, c, d});
  }
  return s;
}

inline Surface<2> circle(int n, double radius, const Vec<2>& centre, bool clockwise = false) {
  Surface<2> s;
  for (int i = 0; i < n; ++i) {
    const double a = (clockwise ? -2 : 2) * std::numbers::pi * i / n;
    s.vertices.push_back(centre + radius * Vec<2>(std::cos(a), std::sin(a)));
    s.facets.push_back({i, (i + 1) % n});
  }
  return s;
}

/// One surface that holds the parts of both.
template <int Dim>
Surface<Dim> both(Surface<Dim> a, const Surface<Dim>& b) {
  const auto shift = static_cast<Index>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (auto facet : b.facets) {
    for (Index& v : facet) v += shift;
    a.facets.push_back(facet);
  }
  return a;
}

}  // namespace shellmatch::testing
