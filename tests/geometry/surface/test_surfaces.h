#pragma once
/// \file
/// Surfaces for tests, most of them with exactly known properties.

#include "geometry/surface/surface.h"

#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace shellmatch::test {

/// Octahedron whose facets are divided by 4 `level` times, vertices on the unit sphere: 8 4^level facets.
Surface<3> unit_sphere(int level);
/// Torus about the z axis: radius of the core circle, radius of the tube, numbers of vertices around both.
Surface<3> torus(double core, double tube, int n_core, int n_tube);
/// 12 triangles.
Surface<3> box(const Vec<3>& min, const Vec<3>& max);
/// Tetrahedron (a wedge) with a long sharp edge from (0, 0, 0) to (1, 0, 0), on whose one side only the point
/// in its middle is a corner; a triangle without area closes the gap.
Surface<3> wedge_with_flat_triangle(double thickness);
/// Counter-clockwise polygon through the points r(t) (cos t, sin t).
Surface<2> polygon(int n, const std::function<double(double)>& radius);

template <int Dim>
Surface<Dim> mapped(Surface<Dim> surface, const std::function<Vec<Dim>(const Vec<Dim>&)>& map) {
  for (Vec<Dim>& x : surface.vertices) x = map(x);
  return surface;
}

/// The other orientation.
template <int Dim>
Surface<Dim> reversed(Surface<Dim> surface) {
  for (auto& facet : surface.facets) std::swap(facet[0], facet[1]);
  return surface;
}

template <int Dim>
Surface<Dim> joined(Surface<Dim> a, const Surface<Dim>& b) {
  const auto offset = static_cast<Index>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (auto facet : b.facets) {
    for (Index& v : facet) v += offset;
    a.facets.push_back(facet);
  }
  return a;
}

/// Area of a surface, length of an outline.
template <int Dim>
double boundary_measure(const Surface<Dim>& surface) {
  double sum = 0;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) sum += facet_measure(surface, static_cast<Index>(f));
  return sum;
}

/// A file of the data folder as a surface of triangles, scaled to a longest side of 1; nothing where there is
/// none.
std::optional<Surface<3>> data_surface(const std::string& file);

/// Points with uniformly distributed coordinates; the same ones on every run.
template <int Dim>
std::vector<Vec<Dim>> random_points(int n, const Vec<Dim>& min, const Vec<Dim>& max, unsigned seed = 1) {
  std::mt19937 generator(seed);
  std::vector<Vec<Dim>> points(static_cast<std::size_t>(n));
  for (Vec<Dim>& x : points)
    for (int i = 0; i < Dim; ++i) x[i] = min[i] + (max[i] - min[i]) * static_cast<double>(generator()) / 4294967296.0;
  return points;
}

/// Random points in the bounding box made larger by a third on all sides, and as many next to the surface: at
/// random distances from its vertices, midpoints of edges and facets.
template <int Dim>
std::vector<Vec<Dim>> query_points(const Surface<Dim>& surface, int n, unsigned seed = 1) {
  const Box<Dim> all = bounding_box(surface.vertices);
  const Vec<Dim> size = all.max - all.min;
  auto points = random_points<Dim>(n, all.min - size / 3, all.max + size / 3, seed);
  const auto noise = random_points<Dim>(n, Vec<Dim>::Constant(-1), Vec<Dim>::Ones(), seed + 1);
  std::mt19937 generator(seed + 2);
  for (int i = 0; i < n; ++i) {
    const auto& facet = surface.facets[generator() % surface.facets.size()];
    const auto n_mixed = static_cast<int>(generator() % Dim) + 1;
    Vec<Dim> x = Vec<Dim>::Zero();
    for (int k = 0; k < n_mixed; ++k) x += surface.vertices[facet[k]] / n_mixed;
    const double scale = std::pow(10.0, -1 - static_cast<int>(generator() % 6)) * size.maxCoeff();
    points.push_back(x + scale * noise[static_cast<std::size_t>(i)]);
  }
  return points;
}

}  // namespace shellmatch::test
