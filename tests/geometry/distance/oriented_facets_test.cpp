#include "geometry/distance/nearest_facets.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

// Two boxes with a gap of 0.1: from within it the nearest face is that of the other box.
TEST(OrientedFacets, TakeTheNearestOfThoseThatFaceTheSameWay) {
  const Surface<3> boxes = joined(box({0, 0, 0}, {1, 1, 1}), box({0, 0, 1.1}, {1, 1, 2.1}));
  const OrientedFacets<3> facets(boxes);
  const Vec<3> x(0.4, 0.3, 1.09);
  ASSERT_EQ(facet_normal(boxes, FacetTree<3>(boxes).nearest(x)).normalized(), Vec<3>(0, 0, -1));
  const auto up = facets.nearest(x, {0.1, 0.2, 1}), down = facets.nearest(x, {0.1, 0.2, -1});
  ASSERT_TRUE(up && down);
  EXPECT_EQ(up->point.point, Vec<3>(0.4, 0.3, 1));
  EXPECT_NEAR(up->distance, 0.09, 1e-15);
  EXPECT_EQ(facet_normal(boxes, up->facet).normalized(), Vec<3>(0, 0, 1));
  EXPECT_EQ(down->point.point, Vec<3>(0.4, 0.3, 1.1));
  EXPECT_FALSE(facets.nearest(x, Vec<3>::Zero()));
}

TEST(OrientedFacets, OnACurvedSurfaceEveryPointFindsItsOwnSide) {
  const Surface<3> ball = unit_sphere(4);
  const OrientedFacets<3> facets(ball);
  std::size_t n_others = 0;
  for (const Vec<3>& v : ball.vertices) {
    const auto own = facets.nearest(0.3 * v, v), other = facets.nearest(0.3 * v, -v);
    ASSERT_TRUE(own);
    EXPECT_NEAR(own->distance, 0.7, 0.02);
    if (!other) continue;
    EXPECT_GT(other->distance, 1.02);  // beyond the equator
    EXPECT_LT(other->distance, 1.31);
    ++n_others;
  }
  EXPECT_GT(n_others, ball.vertices.size() / 2);
}

TEST(OrientedFacets, AHalfHasNoneThatFaceTheOtherWay) {
  const Surface<2> line{{{0, 0}, {1, 0}}, {{0, 1}}};  // faces down
  const OrientedFacets<2> facets(line);
  EXPECT_TRUE(facets.nearest({0.5, 1}, {0, -1}));
  EXPECT_FALSE(facets.nearest({0.5, 1}, {0, 1}));
}

}  // namespace
}  // namespace shellmatch
