#include "geometry/surface/self_intersections.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

TEST(SelfIntersections, EmbeddedSurfacesHaveNone) {
  EXPECT_TRUE(self_intersecting_facets(unit_sphere(4)).empty());
  EXPECT_TRUE(self_intersecting_facets(torus(0.6, 0.2, 30, 20)).empty());
  EXPECT_TRUE(self_intersecting_facets(box({0, 0, 0}, {1, 1, 1})).empty());
  EXPECT_TRUE(self_intersecting_facets(polygon(100, [](double t) { return 1 + 0.4 * std::cos(5 * t); })).empty());
}

TEST(SelfIntersections, OfTwoBoxesAreTheFacetsAtTheirCommonCurve) {
  // The small box sticks out of the top of the large one: its four sides (8 triangles) cross the two
  // triangles there; its bottom and top cross nothing.
  const Surface<3> large = box({0, 0, 0}, {1, 1, 1}), small = box({0.3, 0.35, 0.5}, {0.6, 0.7, 1.5});
  const auto found = self_intersecting_facets(joined(large, small));
  EXPECT_EQ(found, (std::vector<Index>{2, 3, 16, 17, 18, 19, 20, 21, 22, 23}));
}

TEST(SelfIntersections, OfFoldedNeighboursAreFound) {
  Surface<3> s;
  s.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.8, 0}};
  s.facets = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_EQ(self_intersecting_facets(s).size(), 2u);  // folded onto itself about the common edge
  s.vertices[3].z() = 1e-12;
  EXPECT_TRUE(self_intersecting_facets(s).empty());
  // Common corner only: the second triangle pierces the first.
  s.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}};
  s.facets = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_EQ(self_intersecting_facets(s).size(), 2u);
  s.vertices[3] = {-0.5, -0.5, 1};
  s.vertices[4] = {-0.5, -0.5, -1};
  EXPECT_TRUE(self_intersecting_facets(s).empty());
}

TEST(SelfIntersections, OfCurvesAreFound) {
  Surface<2> eight;
  eight.vertices = {{0, 0}, {2, 1}, {2, 0}, {0, 1}};
  eight.facets = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  EXPECT_EQ(self_intersecting_facets(eight), (std::vector<Index>{0, 2}));
  Surface<2> spike;  // there and back on the same line
  spike.vertices = {{0, 0}, {1, 0}, {0.5, 0}};
  spike.facets = {{0, 1}, {1, 2}};
  EXPECT_EQ(self_intersecting_facets(spike).size(), 2u);
  spike.vertices[2] = {1.5, 0};  // straight on
  EXPECT_TRUE(self_intersecting_facets(spike).empty());
}

}  // namespace
}  // namespace shellmatch
