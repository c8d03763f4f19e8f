// The inverse of a map carries a surface that the deformed one does not quite reach.
#include "matching/result/reference_map.h"

#include "geometry/surface/subdivision.h"
#include "matching/level/deformation.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {
namespace {

/// Keeps y <= 1/2 and presses 1/2 < y <= 3/4 together to a twentieth; above it is stretched to fill the square.
double pressed(double y) { return y <= 0.5 ? y : y <= 0.75 ? 0.5 + 0.05 * (y - 0.5) : 0.5125 + 1.95 * (y - 0.75); }

class Pressed : public ::testing::Test {
 protected:
  Pressed() {
    for (Index n = 0; n < grid.n_nodes(); ++n) {
      const Vec<2> x = grid.node_position(n);
      phi.emplace_back(x.x(), pressed(x.y()));
    }
  }
  /// A slab from y = 0.25 to `top`, which faces outward.
  static Surface<2> slab(double top) {
    return subdivided(Surface<2>{{{0.3, 0.25}, {0.7, 0.25}, {0.7, top}, {0.3, top}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
                      0.02);
  }
  static double highest(const Surface<2>& s) {
    return std::ranges::max_element(s.vertices, {}, [](const Vec<2>& x) { return x.y(); })->y();
  }

  Octree<2> grid{5};
  std::vector<Vec<2>> phi;
  const Surface<2> template_shape = slab(0.5);
};

TEST_F(Pressed, WhatLiesOnTheDeformedSurfaceGoesBackExactly) {
  const InverseCarrier<2> carry(template_shape, grid, phi);
  const Surface<2> there = deformed_surface(template_shape, grid, phi), back = carry(there);
  for (std::size_t v = 0; v < back.vertices.size(); ++v)
    EXPECT_LT((back.vertices[v] - template_shape.vertices[v]).norm(), 1e-12);
}

TEST_F(Pressed, WhatItMissesIsNotDrawnOut) {
  const InverseCarrier<2> carry(template_shape, grid, phi);
  const double missed = 0.01;  // the inverse alone takes it twenty times as far
  const Surface<2> reference = slab(0.5 + missed);
  ASSERT_NEAR((*InverseMap<2>(grid, phi)(Vec<2>(0.5, 0.5 + missed))).y(), 0.7, 1e-12);
  EXPECT_LT(highest(carry(reference)), 0.5 + 2 * missed);
  EXPECT_GT(highest(carry(reference)), 0.5 + missed);
  // A point whose side is not known is left to the inverse.
  EXPECT_NEAR((*carry(Vec<2>(0.5, 0.5 + missed), Vec<2>::Zero())).y(), 0.7, 1e-12);
}

TEST_F(Pressed, FarPartsFollowTheInverse) {
  const InverseCarrier<2> carry(template_shape, grid, phi);
  const Vec<2> far(0.5, 0.5 + 4.1 / 32);
  EXPECT_EQ(*carry(far, Vec<2>(0, 1)), *InverseMap<2>(grid, phi)(far));
}

// Beside what was pressed together over a long way: limbs are stretched fourfold at most.
TEST_F(Pressed, NothingIsDrawnOutManyTimes) {
  grid = Octree<2>(6);
  phi.clear();
  for (Index n = 0; n < grid.n_nodes(); ++n) {
    const Vec<2> x = grid.node_position(n);
    phi.emplace_back(x.x(), x.y() <= 0.5      ? x.y()
                            : x.y() <= 0.9375 ? 0.5 + 0.14 * (x.y() - 0.5)
                                              : 1 - 7.02 * (1 - x.y()));
  }
  const InverseCarrier<2> carry(template_shape, grid, phi);
  const double missed = 0.06;
  ASSERT_GT((*InverseMap<2>(grid, phi)(Vec<2>(0.5, 0.5 + missed))).y(), 0.5 + 7 * missed);
  const double y = carry(Vec<2>(0.5, 0.5 + missed), Vec<2>(0, 1))->y();
  EXPECT_LT(y, 0.5 + 4 * missed);
  EXPECT_GT(y, 0.5 + 2 * missed);
}

}  // namespace
}  // namespace shellmatch
