// What of a surface lies inside the body that it encloses, on boxes that overlap.

#include "geometry/distance/buried_parts.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

TEST(BuriedParts, NoneWhereNothingCrosses) {
  EXPECT_EQ(buried_parts(unit_sphere(4)).n_vertices, 0u);
  // A cavity's surface lies inside another one, but winds the other way.
  Surface<3> cavity = box({0.3, 0.3, 0.3}, {0.6, 0.6, 0.6});
  for (auto& facet : cavity.facets) std::swap(facet[0], facet[1]);
  EXPECT_EQ(buried_parts(joined(box({0, 0, 0}, {1, 1, 1}), cavity)).n_vertices, 0u);
}

TEST(BuriedParts, OfSpheresThatOverlapAreTheCapsOfBoth) {
  Surface<3> left = unit_sphere(4), right = left;
  for (Vec<3>& x : right.vertices) x.x() += 1.6;
  std::size_t n_within = 0;  // the facets lie up to 0.005 within the sphere, and those of the common circle do not count
  for (const Vec<3>& x : left.vertices) n_within += (x - Vec<3>(1.6, 0, 0)).norm() < 0.9;
  const BuriedParts found = buried_parts(joined(left, right));
  EXPECT_GT(n_within, 30u);
  EXPECT_GE(found.n_vertices, 2 * n_within);
  EXPECT_LE(found.n_vertices, 4 * n_within);
  EXPECT_NEAR(found.depth, 0.4, 0.01);  // each apex lies 0.4 below the other sphere
}

TEST(BuriedParts, AWholeComponentWithinAnother) {
  const BuriedParts found = buried_parts(joined(joined(box({0, 0, 0}, {1, 1, 1}), box({0.9, 0.9, 0.9}, {1.1, 1.1, 1.1})), box({0.3, 0.4, 0.4}, {0.6, 0.6, 0.6})));
  EXPECT_EQ(found.n_vertices, 8u);  // the facets of the other two cross each other
  EXPECT_NEAR(found.depth, 0.4, 1e-12);
}

TEST(BuriedParts, TheLargestWhereThereAreMany) {
  Surface<3> s = joined(box({0, 0, 0}, {1, 1, 1}), box({0.9, 0.9, 0.9}, {1.1, 1.1, 1.1}));
  for (int i = 0; i < 70; ++i) {
    const Vec<3> corner(0.1 + 0.07 * (i % 10), 0.1 + 0.1 * (i / 10), 0.1);
    s = joined(s, box(corner, corner + Vec<3>(0.05, 0.05, 0.05)));
  }
  EXPECT_EQ(buried_parts(s).n_vertices, 64u * 8u);
}

}  // namespace
}  // namespace shellmatch
