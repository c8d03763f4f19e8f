#include "geometry/curvature/curvature.h"

#include "base/error.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

// Next and previous vertex along the ring; no_index where it does not exist or is not unique.
struct Neighbours {
  std::vector<Index> next, previous;
  explicit Neighbours(const Surface<2>& curve)
      : next(curve.vertices.size(), no_index), previous(curve.vertices.size(), no_index) {
    std::vector<char> ambiguous(curve.vertices.size(), 0);
    for (const auto& [a, b] : curve.facets) {
      if (next[a] != no_index || previous[b] != no_index) ambiguous[next[a] != no_index ? a : b] = 1;
      next[a] = b;
      previous[b] = a;
    }
    for (std::size_t v = 0; v < ambiguous.size(); ++v)
      if (ambiguous[v]) next[v] = previous[v] = no_index;
  }
};

// Curvature at s = 0 of the parabola fitted to the points (s, z): second derivative over (1 + slope^2)^(3/2).
double parabola_curvature(const std::vector<Vec<2>>& points) {
  Mat<3> matrix = Mat<3>::Zero();
  Vec<3> right_side = Vec<3>::Zero();
  double size = 0;
  for (const Vec<2>& p : points) size = std::max(size, std::abs(p[0]));
  for (const Vec<2>& p : points) {
    const double s = p[0] / size;
    const Vec<3> monomials(1, s, s * s);
    matrix += monomials * monomials.transpose();
    right_side += p[1] * monomials;
  }
  const Vec<3> c = matrix.ldlt().solve(right_side);
  const double slope = c[1] / size, second = 2 * c[2] / (size * size);
  return second / std::pow(1 + slope * slope, 1.5);
}

}  // namespace

std::vector<double> curve_curvatures(const Surface<2>& curve, int n_rings) {
  SHELLMATCH_CHECK(n_rings >= 1, "a parabola needs a neighbour on each side");
  const Neighbours neighbours(curve);
  std::vector<double> curvatures(curve.vertices.size(), std::numeric_limits<double>::quiet_NaN());
  for (Index v = 0; v < static_cast<Index>(curve.vertices.size()); ++v) {
    std::vector<Index> nearby{v};
    for (const auto* step : {&neighbours.previous, &neighbours.next}) {
      Index w = v;
      for (int r = 0; r < n_rings && w != no_index; ++r) {
        w = (*step)[w];
        if (w != no_index && std::find(nearby.begin(), nearby.end(), w) == nearby.end()) nearby.push_back(w);
      }
    }
    if (nearby.size() != 2 * static_cast<std::size_t>(n_rings) + 1) continue;
    const Index first = nearby[n_rings], last = nearby.back();
    const Vec<2> origin = curve.vertices[v];
    const Vec<2> tangent = (curve.vertices[last] - curve.vertices[first]).normalized();
    const Vec<2> inward(-tangent[1], tangent[0]);
    std::vector<Vec<2>> points;
    for (const Index w : nearby) {
      const Vec<2> x = curve.vertices[w] - origin;
      points.emplace_back(tangent.dot(x), inward.dot(x));
    }
    curvatures[v] = parabola_curvature(points);
  }
  return curvatures;
}

}  // namespace shellmatch
