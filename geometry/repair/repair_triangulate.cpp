// Triangulation of polygons: fans for convex ones, ear clipping in the plane of the polygon for others.
// Meisters, 'Polygons have ears', American Mathematical Monthly 82(6), 1975.
#include "geometry/repair/repair_steps.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shellmatch {
namespace {

double turn(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Projects onto the plane of the vector area (Newell), where the polygon is counter-clockwise.
std::vector<Vec<2>> flattened(const std::vector<Vec<3>>& x) {
  Vec<3> area = Vec<3>::Zero();
  for (std::size_t i = 1; i + 1 < x.size(); ++i) area += (x[i] - x[0]).cross(x[i + 1] - x[0]);
  const Vec<3> normal = area.stableNormalized();
  const Vec<3> u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vec<2>> flat;
  for (const Vec<3>& p : x) flat.emplace_back(u.dot(p - x[0]), v.dot(p - x[0]));
  return flat;
}

// True if all corners are convex and all triangles of the fan have positive area (which excludes pentagrams).
bool is_convex(const std::vector<Vec<2>>& x) {
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn(x[i], x[(i + 1) % n], x[(i + 2) % n]) <= 0) return false;
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (turn(x[0], x[i], x[i + 1]) <= 0) return false;
  return true;
}

// True for a convex corner whose triangle contains no other corner. Adds the number of corners looked at to n_tests.
bool is_ear(const std::vector<Vec<2>>& x, const std::vector<std::size_t>& ring, std::size_t k, std::size_t& n_tests) {
  const std::size_t n = ring.size();
  const std::size_t i = ring[(k + n - 1) % n], j = ring[k], l = ring[(k + 1) % n];
  if (turn(x[i], x[j], x[l]) <= 0) return false;
  const auto inside = std::find_if(ring.begin(), ring.end(), [&](std::size_t m) {
    if (x[m] == x[i] || x[m] == x[j] || x[m] == x[l]) return false;
    return turn(x[i], x[j], x[m]) >= 0 && turn(x[j], x[l], x[m]) >= 0 && turn(x[l], x[i], x[m]) >= 0;
  });
  n_tests += static_cast<std::size_t>(inside - ring.begin()) + 1;
  return inside == ring.end();
}

// Of a polygon that crosses itself with n corners, n^3 may be looked at. After so many (seconds) the rest becomes a fan.
constexpr std::size_t max_tests = 200'000'000;

void clip_ears(const std::vector<Vec<2>>& x, const std::vector<Index>& corners, Triangles& triangles) {
  std::vector<std::size_t> ring(corners.size());
  for (std::size_t k = 0; k < ring.size(); ++k) ring[k] = k;
  std::size_t k = 0, n_refused = 0, n_tests = 0;
  while (ring.size() > 3 && n_tests < max_tests) {
    k %= ring.size();
    // A polygon that crosses itself may have no ear. Any corner is then cut off, which keeps the edges
    // closed.
    if (!is_ear(x, ring, k, n_tests) && ++n_refused <= ring.size()) {
      ++k;
      continue;
    }
    const std::size_t n = ring.size();
    triangles.push_back({corners[ring[(k + n - 1) % n]], corners[ring[k]], corners[ring[(k + 1) % n]]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
    n_refused = 0;
  }
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) triangles.push_back({corners[ring[0]], corners[ring[i]], corners[ring[i + 1]]});
}

}  // namespace

Triangles triangulate(const OriginalShape<3>& shape, std::vector<Index>* polygon_of) {
  Triangles triangles;
  std::vector<Index> corners;
  for (std::size_t p = 0; p < shape.polygons.size(); ++p) {
    corners.clear();
    for (const Index v : shape.polygons[p])
      if (corners.empty() || corners.back() != v) corners.push_back(v);
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    std::vector<Vec<2>> flat;
    if (corners.size() > 3) {
      std::vector<Vec<3>> x;
      for (const Index v : corners) x.push_back(shape.vertices[v]);
      flat = flattened(x);
    }
    if (!flat.empty() && !is_convex(flat)) {
      clip_ears(flat, corners, triangles);
    } else {
      for (std::size_t k = 1; k + 1 < corners.size(); ++k) triangles.push_back({corners[0], corners[k], corners[k + 1]});
    }
    if (polygon_of) polygon_of->resize(triangles.size(), static_cast<Index>(p));
  }
  return triangles;
}

}  // namespace shellmatch
