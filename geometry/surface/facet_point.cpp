#include "geometry/surface/facet_point.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace shellmatch {

namespace {

/// Nearest point of the edge from corner i to corner k of a facet.
template <int Dim>
FacetPoint<Dim> closest_on_edge(const Vec<Dim>& a, const Vec<Dim>& b, int i, int k, const Vec<Dim>& x) {
  const Vec<Dim> edge = b - a;
  const double length2 = edge.squaredNorm();
  const double t = length2 > 0 ? (x - a).dot(edge) / length2 : 0;
  if (t <= 0) return {a, 1u << i};
  if (t >= 1) return {b, 1u << k};
  return {a + t * edge, 1u << i | 1u << k};
}

FacetPoint<2> closest_on(const std::array<Vec<2>, 2>& corners, const Vec<2>& x) {
  return closest_on_edge(corners[0], corners[1], 0, 1, x);
}

// The nearest point of the three edges, unless x lies in the prism over the triangle. There the point is
// computed from its barycentric coordinates and not by subtracting the normal, so that it lies in even the
// thinnest triangle.
FacetPoint<3> closest_on(const std::array<Vec<3>, 3>& corners, const Vec<3>& x) {
  const auto& [a, b, c] = corners;
  FacetPoint<3> best = closest_on_edge(a, b, 0, 1, x);
  double best_distance2 = (best.point - x).squaredNorm();
  const auto compare = [&](const FacetPoint<3>& other) {
    const double distance2 = (other.point - x).squaredNorm();
    if (distance2 < best_distance2) {
      best = other;
      best_distance2 = distance2;
    }
  };
  compare(closest_on_edge(b, c, 1, 2, x));
  compare(closest_on_edge(a, c, 0, 2, x));
  const Vec<3> e1 = b - a, e2 = c - a, w = x - a;
  if (!is_degenerate(e1, e2)) {
    const Vec<3> n = e1.cross(e2), m = w.cross(n) / n.squaredNorm();
    const double beta = -m.dot(e2), gamma = m.dot(e1);
    if (beta > 0 && gamma > 0 && beta + gamma < 1) compare({a + beta * e1 + gamma * e2, inside_facet<3>});
  }
  return best;
}

}  // namespace

// The rounding error of the cross product is about 1e-16 times the squared length, so the normal has at least
// six digits.
bool is_degenerate(const Vec<3>& edge_1, const Vec<3>& edge_2) {
  const double length2 = std::max(edge_1.squaredNorm(), edge_2.squaredNorm());
  return !(edge_1.cross(edge_2).norm() > 1e-10 * length2);
}

template <int Dim>
FacetPoint<Dim> closest_point_on_facet(const Surface<Dim>& surface, Index f, const Vec<Dim>& x) {
  std::array<Vec<Dim>, Dim> corners;
  for (int i = 0; i < Dim; ++i) corners[i] = surface.vertices[surface.facets[f][i]];
  return closest_on(corners, x);
}

template <int Dim>
std::array<double, Dim> barycentric_coordinates(const Surface<Dim>& surface, Index f, const FacetPoint<Dim>& nearest) {
  std::array<double, Dim> weights{};
  const auto corner = [&](int k) { return surface.vertices[surface.facets[f][k]]; };
  int first = -1, second = -1, n = 0;
  for (int k = 0; k < Dim; ++k)
    if (nearest.feature >> k & 1u) (n++ == 0 ? first : second) = k;
  if constexpr (Dim == 3) {
    if (n == 3) {
      const Vec<3> e1 = corner(1) - corner(0), e2 = corner(2) - corner(0), w = nearest.point - corner(0);
      const Vec<3> normal = e1.cross(e2), m = w.cross(normal) / normal.squaredNorm();
      const double beta = std::max(0.0, -m.dot(e2)), gamma = std::max(0.0, m.dot(e1)),
                   sum = std::max(1.0, beta + gamma);
      return {1 - (beta + gamma) / sum, beta / sum, gamma / sum};
    }
  }
  if (n == 1) {
    weights[static_cast<std::size_t>(first)] = 1;
    return weights;
  }
  const double length = (corner(second) - corner(first)).norm();
  const double t = length > 0 ? std::min(1.0, (nearest.point - corner(first)).norm() / length) : 0;
  weights[static_cast<std::size_t>(first)] = 1 - t;
  weights[static_cast<std::size_t>(second)] = t;
  return weights;
}

SHELLMATCH_2D_3D(closest_point_on_facet);
template std::array<double, 2> barycentric_coordinates<2>(const Surface<2>&, Index, const FacetPoint<2>&);
template std::array<double, 3> barycentric_coordinates<3>(const Surface<3>&, Index, const FacetPoint<3>&);

}  // namespace shellmatch
