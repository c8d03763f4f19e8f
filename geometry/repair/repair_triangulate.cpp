// Triangulation of polygons: fans for convex ones, ear clipping in the plane of the polygon for others.
// Meisters, 'Polygons have ears', American Mathematical Monthly 82(6), 1975.
#include "geometry/repair/repair_steps.h"

#include "geometry/surface/pseudonormals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace shellmatch {
namespace {

double turn(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Projects onto the plane of the vector area (Newell), where the polygon is counter-clockwise.
std::vector<Vec<2>> flattened(const std::vector<Vec<3>>& x) {
  Vec<3> area = Vec<3>::Zero();
  for (std::size_t i = 1; i + 1 < x.size(); ++i) area += (x[i] - x[0]).cross(x[i + 1] - x[0]);
  const Vec<3> normal = unit_or_zero(area);
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

// The reflex corners of a polygon, in a tree of boxes. Of a polygon that does not cross itself only these can lie in
// the triangle of a convex corner, and what has become convex stays so: the tree only loses corners.
class ReflexCorners {
 public:
  ReflexCorners(const std::vector<Vec<2>>& x, std::vector<std::size_t> corners)
      : x_(x), corners_(std::move(corners)), place_(x.size(), absent), nodes_(2 * std::bit_ceil(corners_.size() + 1)) {
    build(0, 0, corners_.size());
    for (std::size_t k = 0; k < corners_.size(); ++k) place_[corners_[k]] = k;
  }

  void remove(std::size_t corner) {
    const std::size_t place = std::exchange(place_[corner], absent);
    if (place == absent) return;
    std::size_t node = 0, begin = 0, end = corners_.size();
    while (--nodes_[node].n_left, end - begin > most_in_leaf) {
      const std::size_t middle = (begin + end) / 2;
      node = 2 * node + (place < middle ? 1 : 2);
      (place < middle ? end : begin) = middle;
    }
  }

  // Is there one in the triangle, or on its border, that does not lie where a corner of it does? Adds to n_tests what
  // it looks at.
  bool any_in(const std::array<Vec<2>, 3>& triangle, std::size_t& n_tests) const {
    return any_in(triangle, 0, 0, corners_.size(), n_tests);
  }

 private:
  static constexpr std::size_t absent = static_cast<std::size_t>(-1), most_in_leaf = 8;
  struct Node {
    Box<2> box;
    std::size_t n_left = 0;
  };

  void build(std::size_t node, std::size_t begin, std::size_t end) {
    Box<2>& box = nodes_[node].box;
    for (std::size_t k = begin; k < end; ++k) box.add(x_[corners_[k]]);
    nodes_[node].n_left = end - begin;
    if (end - begin <= most_in_leaf) return;
    const int axis = box.max.x() - box.min.x() > box.max.y() - box.min.y() ? 0 : 1;
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t k) { return corners_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(middle), at(end),
                     [&](std::size_t a, std::size_t b) { return x_[a][axis] < x_[b][axis]; });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
  }

  // Is the whole box to the right of one of the edges? A turn, in floating point as well, is greatest at a corner of
  // the box.
  static bool is_outside(const std::array<Vec<2>, 3>& triangle, const Box<2>& box) {
    for (std::size_t e = 0; e < 3; ++e) {
      const Vec<2>&a = triangle[e], &b = triangle[(e + 1) % 3];
      if (turn(a, b, {b.y() > a.y() ? box.min.x() : box.max.x(), b.x() > a.x() ? box.max.y() : box.min.y()}) < 0)
        return true;
    }
    return false;
  }

  bool any_in(const std::array<Vec<2>, 3>& triangle, std::size_t node, std::size_t begin, std::size_t end,
              std::size_t& n_tests) const {
    ++n_tests;
    if (nodes_[node].n_left == 0 || is_outside(triangle, nodes_[node].box)) return false;
    if (end - begin > most_in_leaf) {
      const std::size_t middle = (begin + end) / 2;
      return any_in(triangle, 2 * node + 1, begin, middle, n_tests) ||
             any_in(triangle, 2 * node + 2, middle, end, n_tests);
    }
    const auto& [a, b, c] = triangle;
    for (std::size_t k = begin; k < end; ++k) {
      const Vec<2>& p = x_[corners_[k]];
      if (place_[corners_[k]] == absent || p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return true;
    }
    return false;
  }

  const std::vector<Vec<2>>& x_;
  std::vector<std::size_t> corners_, place_;  // place_: of a corner in corners_, as long as it is there
  std::vector<Node> nodes_;
};

// A polygon that crosses itself may be looked at for long. After so much of that (seconds) the rest becomes a fan.
constexpr std::size_t max_tests = 100'000'000;

// False where that is so.
bool clip_ears(const std::vector<Vec<2>>& x, const std::vector<Index>& corners, Triangles& triangles) {
  const std::size_t n = corners.size();
  std::vector<std::size_t> before(n), after(n), reflex;
  for (std::size_t k = 0; k < n; ++k) {
    before[k] = (k + n - 1) % n;
    after[k] = (k + 1) % n;
  }
  const auto is_convex_corner = [&](std::size_t k) { return turn(x[before[k]], x[k], x[after[k]]) > 0; };
  for (std::size_t k = 0; k < n; ++k)
    if (!is_convex_corner(k)) reflex.push_back(k);
  ReflexCorners others(x, std::move(reflex));
  std::size_t first = 0, k = 0, n_left = n, n_refused = 0, n_tests = 0;
  for (; n_left > 3 && n_tests < max_tests; ++n_tests) {
    const std::size_t i = before[k], l = after[k];
    const bool is_ear = is_convex_corner(k) && !others.any_in({x[i], x[k], x[l]}, n_tests);
    // A polygon that crosses itself may have no ear. Any corner is then cut off, which keeps the edges
    // closed.
    if (is_ear || ++n_refused > n_left) {
      triangles.push_back({corners[i], corners[k], corners[l]});
      after[i] = l;
      before[l] = i;
      if (k == first) first = l;
      others.remove(k);
      for (const std::size_t neighbour : {i, l})
        if (is_convex_corner(neighbour)) others.remove(neighbour);
      --n_left;
      n_refused = 0;
    }
    k = l;
  }
  for (std::size_t m = after[first]; after[m] != first; m = after[m])
    triangles.push_back({corners[first], corners[m], corners[after[m]]});
  return n_left <= 3;
}

}  // namespace

Triangles triangulate(const OriginalShape<3>& shape, std::vector<Index>* polygon_of, std::size_t* n_given_up) {
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
      const bool is_done = clip_ears(flat, corners, triangles);
      if (n_given_up && !is_done) ++*n_given_up;
    } else {
      for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        triangles.push_back({corners[0], corners[k], corners[k + 1]});
    }
    if (polygon_of) polygon_of->resize(triangles.size(), static_cast<Index>(p));
  }
  return triangles;
}

}  // namespace shellmatch
