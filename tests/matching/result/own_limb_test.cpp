// A hairpin, whose arms all but touch: points that lie next to the other arm come back to their own, and nothing else
// moves.
#include "matching/result/own_limb.h"

#include "geometry/surface/subdivision.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

constexpr double radius = 0.055, half_width = 0.05, gap = 2 * (radius - half_width);

// A bar along x, folded in the middle: its arms lie along y, `gap` apart from each other across x = 0.
Vec<3> folded(const Vec<3>& x) {
  const double bend = radius * std::numbers::pi / 2, across = radius + x.y();
  if (std::abs(x.x()) > bend) return {std::copysign(across, x.x()), bend - std::abs(x.x()), x.z()};
  const double angle = x.x() / radius;
  return {across * std::sin(angle), across * std::cos(angle), x.z()};
}

struct Hairpin {
  Surface<3> bar = subdivided(test::box({-1, -half_width, -half_width}, {1, half_width, half_width}), 0.04);
  Surface<3> hairpin = test::mapped<3>(bar, folded);
  std::vector<SurfacePair> pairs = identical_pairs();

  std::vector<SurfacePair> identical_pairs() const {
    std::vector<SurfacePair> list;
    for (std::size_t v = 0; v < bar.vertices.size(); v += 3) list.push_back({bar.vertices[v], hairpin.vertices[v]});
    return list;
  }
  // Vertices of one arm that face the other one.
  bool faces_other_arm(std::size_t v) const {
    return bar.vertices[v].x() > 0.4 && bar.vertices[v].x() < 0.9 && bar.vertices[v].y() < -0.99 * half_width;
  }
  // The vertices where they belong, but those of one arm moved by `step` towards the other one.
  std::vector<Vec<3>> displaced(double step) const {
    std::vector<Vec<3>> points = hairpin.vertices;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (faces_other_arm(v)) points[v].x() -= step;
    return points;
  }
  std::size_t lay(std::vector<Vec<3>>& carried) const {
    return lay_on_own_limbs(bar, hairpin, pairs, bar.vertices, carried);
  }
  double largest_error(const std::vector<Vec<3>>& carried) const {
    double largest = 0;
    for (std::size_t v = 0; v < carried.size(); ++v)
      largest = std::max(largest, (carried[v] - hairpin.vertices[v]).norm());
    return largest;
  }
};

TEST(OwnLimb, PointsOnTheOtherArmComeBack) {
  const Hairpin h;
  std::vector<Vec<3>> carried = h.displaced(0.9 * gap);
  std::size_t n = 0;
  for (std::size_t v = 0; v < carried.size(); ++v) n += h.faces_other_arm(v);
  ASSERT_GT(n, 20u);
  EXPECT_EQ(h.lay(carried), n);
  EXPECT_LT(h.largest_error(carried), 1e-12);
}

TEST(OwnLimb, PointsThatLieByTheirOwnArmStay) {
  const Hairpin h;
  for (const double step : {0.0, 0.4 * gap, -3 * gap}) {
    const std::vector<Vec<3>> before = h.displaced(step);
    std::vector<Vec<3>> carried = before;
    EXPECT_EQ(h.lay(carried), 0u) << step;
    EXPECT_EQ(carried, before) << step;
  }
}

TEST(OwnLimb, WhatIsFarFromItsArmOrHasNoPairStays) {
  Hairpin h;
  const std::vector<Vec<3>> far = h.displaced(10 * gap);
  std::vector<Vec<3>> carried = far;
  EXPECT_EQ(h.lay(carried), 0u) << "no contact of limbs explains this";
  EXPECT_EQ(carried, far);
  std::erase_if(h.pairs, [](const SurfacePair& pair) { return pair.on_reference.x() > 0.2; });
  carried = h.displaced(0.9 * gap);
  EXPECT_EQ(h.lay(carried), 0u) << "nothing says where these belong";
  h.pairs.clear();
  EXPECT_EQ(h.lay(carried), 0u);
}

TEST(OwnLimb, AMapThatDoesNotFollowThePairsStays) {
  Hairpin h;
  for (SurfacePair& pair : h.pairs) pair.on_template.x() = -pair.on_template.x();
  std::vector<Vec<3>> carried = h.displaced(0.9 * gap);
  EXPECT_EQ(h.lay(carried), 0u);
}

}  // namespace
}  // namespace shellmatch
