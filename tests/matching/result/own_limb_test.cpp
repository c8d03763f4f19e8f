// A hairpin, whose arms all but touch: points that lie next to the other arm come back to their own, and nothing else
// moves.
#include "matching/result/own_limb.h"

#include "geometry/surface/subdivision.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

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

TEST(OwnLimb, TheNearestVertexIsOnTheOwnArm) {
  // Not folded in the middle, so that the centres of one arm's facets lie beside vertices of the other one.
  Hairpin h;
  const auto shifted = [](const Vec<3>& x) { return folded(x + Vec<3>(0.01, 0, 0)); };
  h.hairpin = test::mapped<3>(h.bar, shifted);
  h.pairs = h.identical_pairs();
  std::vector<Vec<3>> points = h.bar.vertices, carried = h.hairpin.vertices;
  for (const auto& facet : h.bar.facets) {
    if (!std::ranges::all_of(facet, [&](Index v) { return h.faces_other_arm(v); })) continue;
    points.push_back((h.bar.vertices[facet[0]] + h.bar.vertices[facet[1]] + h.bar.vertices[facet[2]]) / 3);
    carried.push_back(shifted(points.back()));
  }
  const auto n_beside = [&] {
    return std::ranges::count_if(carried | std::views::drop(h.bar.vertices.size()), [&](const Vec<3>& x) {
      const auto distance = [&](const Vec<3>& y) { return (y - x).squaredNorm(); };
      return std::ranges::min_element(h.hairpin.vertices, {}, distance)->x() < 0;
    });
  };
  ASSERT_GT(n_beside(), 10);
  const std::vector<Vec<3>> before = carried;
  EXPECT_GT(lay_on_own_limbs(h.bar, h.hairpin, h.pairs, points, carried), 10u);
  EXPECT_EQ(n_beside(), 0);
  for (std::size_t i = 0; i < carried.size(); ++i) EXPECT_LT((carried[i] - before[i]).norm(), 0.02);
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

// In the user's coordinates, whichever shape is deformed and moved by the pose.
TEST(OwnLimb, PoseAndPlacementAreThoseOfEitherDirection) {
  const Hairpin h;
  MapFrame<3> frame{{0.2, {0.5, 0.4, 0.6}}, {1.1, {3, -2, 1}}};
  frame.pose.rotation = Eigen::AngleAxisd(2, Vec<3>(1, 2, 2) / 3).toRotationMatrix();
  const Similarity<3> none;
  for (const bool is_backward : {false, true}) {
    frame.is_backward = is_backward;
    std::vector<Landmark<3>> pairs;
    for (const SurfacePair& pair : h.pairs)
      pairs.push_back(
          {"", is_backward ? pair.on_template : pair.on_reference, is_backward ? pair.on_reference : pair.on_template});
    const Surface<3> reference = transformed(h.bar, is_backward ? none : frame.pose, frame.placement),
                     hairpin = transformed(h.hairpin, is_backward ? frame.pose : none, frame.placement);
    std::vector<Vec<3>> carried = h.displaced(0.9 * gap);
    EXPECT_GT(lay_on_own_limbs(frame, pairs, {reference, hairpin}, h.bar.vertices, carried), 20u);
    EXPECT_LT(h.largest_error(carried), 1e-12);
  }
}

}  // namespace
}  // namespace shellmatch
