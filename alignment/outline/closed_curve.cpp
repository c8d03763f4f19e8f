#include "alignment/outline/closed_curve.h"

#include "geometry/surface/pseudonormals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shellmatch {

namespace {

/// Places along a closed polygon at equal distances, as multiples of a segment: 2.25 is a quarter behind vertex 2.
std::vector<double> equal_steps(const std::vector<Vec<2>>& polygon, std::size_t n, double& length) {
  std::vector<double> begin{0};
  for (std::size_t i = 0; i < polygon.size(); ++i)
    begin.push_back(begin.back() + (polygon[(i + 1) % polygon.size()] - polygon[i]).norm());
  length = begin.back();
  std::vector<double> places;
  std::size_t segment = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double at = length * static_cast<double>(k) / static_cast<double>(n);
    while (segment + 1 < polygon.size() && begin[segment + 1] <= at) ++segment;
    const double step = begin[segment + 1] - begin[segment];
    places.push_back(static_cast<double>(segment) + (step > 0 ? std::min((at - begin[segment]) / step, 1.0) : 0));
  }
  return places;
}

Vec<2> point_at(const std::vector<Vec<2>>& polygon, double place) {
  const auto i = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(i);
  return (1 - share) * polygon[i % polygon.size()] + share * polygon[(i + 1) % polygon.size()];
}

std::vector<Vec<2>> filtered(const std::vector<Vec<2>>& points, double deviation) {
  const auto n = static_cast<std::ptrdiff_t>(points.size());
  const auto reach = std::min(static_cast<std::ptrdiff_t>(std::ceil(4 * deviation)), n / 2);
  std::vector<Vec<2>> result(points.size(), Vec<2>::Zero());
  double sum = 0;
  for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
    const double share = static_cast<double>(k) / std::max(deviation, 1e-12), weight = std::exp(-0.5 * share * share);
    sum += weight;
    for (std::ptrdiff_t i = 0; i < n; ++i) result[i] += weight * points[(i + k + n) % n];
  }
  for (Vec<2>& x : result) x /= sum;
  return result;
}

double angle_between(const Vec<2>& a, const Vec<2>& b) { return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)); }

}  // namespace

std::vector<std::vector<Index>> closed_polygons(const Surface<2>& outline) {
  std::vector<std::vector<Index>> next(outline.vertices.size());
  for (auto facet = outline.facets.rbegin(); facet != outline.facets.rend(); ++facet)
    next[(*facet)[0]].push_back((*facet)[1]);
  std::vector<std::vector<Index>> polygons;
  for (const auto& facet : outline.facets) {
    std::vector<Index> polygon;
    Index v = facet[0];
    while (!next[v].empty()) {
      polygon.push_back(v);
      const Index to = next[v].back();
      next[v].pop_back();
      v = to;
    }
    if (polygon.size() >= 3 && v == facet[0]) polygons.push_back(polygon);
  }
  return polygons;
}

ClosedCurve smoothed_curve(const std::vector<Vec<2>>& polygon, std::size_t n, double smoothing) {
  constexpr std::array chords{0.02, 0.05, 0.1};
  ClosedCurve curve;
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec<2>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += a.x() * b.y() - a.y() * b.x();
  }
  curve.is_hole = area < 0;
  const std::size_t n_fine = 8 * n;
  double length = 0;
  const std::vector<double> fine_places = equal_steps(polygon, n_fine, length);
  std::vector<Vec<2>> fine;
  for (const double place : fine_places) fine.push_back(point_at(polygon, place));
  const std::vector<Vec<2>> smooth = filtered(fine, smoothing * static_cast<double>(n_fine));
  for (const double place : equal_steps(smooth, n, curve.length)) {
    curve.points.push_back(point_at(smooth, place));
    curve.on_input.push_back(point_at(fine, place));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Vec<2> along = unit_or_zero<2>(curve.points[(i + 1) % n] - curve.points[(i + n - 1) % n]);
    curve.normals.push_back({along.y(), -along.x()});
    for (std::size_t s = 0; s < chords.size(); ++s) {
      const auto h = std::max<std::size_t>(1, static_cast<std::size_t>(chords[s] * static_cast<double>(n) + 0.5));
      const Vec<2> ahead = curve.points[(i + h) % n] - curve.points[i],
                   behind = curve.points[i] - curve.points[(i + n - h) % n];
      curve.turning[s].push_back(angle_between(behind, ahead) / std::numbers::pi);
    }
  }
  return curve;
}

}  // namespace shellmatch
