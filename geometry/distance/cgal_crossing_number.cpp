#include "geometry/distance/winding_number.h"

#include "geometry/distance/cgal_triangle_tree.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

namespace shellmatch {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ExactPoint = Kernel::Point_3;
using ExactTriangle = Kernel::Triangle_3;

constexpr int most_segments = 8;

ExactPoint exact_point(const Vec<3>& x) { return {x.x(), x.y(), x.z()}; }

/// 1 where the segment from x to y leaves through the triangle, -1 where it enters; none where it meets an edge or lies
/// in the triangle's plane. \pre they meet
std::optional<int> crossing(const ExactPoint& x, const ExactPoint& y, const ExactTriangle& t) {
  for (int k = 0; k < 3; ++k)
    if (CGAL::orientation(x, y, t[k], t[(k + 1) % 3]) == CGAL::COPLANAR) return std::nullopt;
  const CGAL::Orientation at_y = CGAL::orientation(t[0], t[1], t[2], y);
  return at_y == CGAL::COPLANAR ? std::nullopt : std::optional(at_y == CGAL::POSITIVE ? 1 : -1);
}

}  // namespace

struct CrossingNumber::Tree {
  explicit Tree(const Surface<3>& s) : surface(s), box(bounding_box(s.vertices)) {
    for (const auto& [a, b, c] : s.facets)
      triangles.emplace_back(exact_point(s.vertices[a]), exact_point(s.vertices[b]), exact_point(s.vertices[c]));
    tree.insert(triangles.begin(), triangles.end());
    tree.build();
  }
  const Surface<3>& surface;
  Box<3> box;
  std::vector<ExactTriangle> triangles;
  CgalTriangleTree<Kernel, std::vector<ExactTriangle>::const_iterator> tree;
};

CrossingNumber::CrossingNumber(const Surface<3>& surface) : tree_(std::make_unique<Tree>(surface)) {}
CrossingNumber::~CrossingNumber() = default;

int CrossingNumber::operator()(const Vec<3>& x) const {
  const ExactPoint from = exact_point(x);
  for (int s = 0; s < most_segments; ++s) {
    // Directions to all sides that no modelled edge is likely to have.
    const double angle = 2.4 * s + 0.7137, height = std::fmod(0.61803 * s + 0.3319, 1.0) * 2 - 1,
                 radius = std::sqrt(1 - height * height);
    const Vec<3> direction(radius * std::cos(angle), radius * std::sin(angle), height);
    const ExactPoint to = exact_point(x + 2 * tree_->box.diagonal() * direction);
    std::vector<std::vector<ExactTriangle>::const_iterator> met;
    tree_->tree.all_intersected_primitives(Kernel::Segment_3(from, to), std::back_inserter(met));
    std::optional<int> sum = 0;
    for (const auto& triangle : met) {
      const std::optional<int> one = crossing(from, to, *triangle);
      sum = sum && one ? std::optional(*sum + *one) : std::nullopt;
    }
    if (sum) return *sum;
  }
  return static_cast<int>(std::lround(winding_number<3>(tree_->surface, x)));
}

}  // namespace shellmatch
