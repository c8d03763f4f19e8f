#include "geometry/surface/surface.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

TEST(Surface, EnclosedMeasureOfBoxAndPolygonIsExact) {
  EXPECT_DOUBLE_EQ(enclosed_measure(box({1, 2, 3}, {2, 4, 6})), 6);
  EXPECT_DOUBLE_EQ(enclosed_measure(reversed(box({1, 2, 3}, {2, 4, 6}))), -6);
  // A square whose corners lie on the axes at distance 2.
  EXPECT_DOUBLE_EQ(enclosed_measure(polygon(4, [](double) { return 2.0; })), 8);
  EXPECT_EQ(enclosed_measure(Surface<3>{}), 0);
}

TEST(Surface, EnclosedMeasureDoesNotCancelFarFromTheOrigin) {
  // Coordinates whose products are rounded, as whole numbers are not.
  const double far = 1e6 + 0.1, side = (far + 0.3) - far;
  const double found = enclosed_measure(box(Vec<3>::Constant(far), Vec<3>::Constant(far + 0.3)));
  EXPECT_NEAR(found / std::pow(side, 3), 1, 1e-14);
}

TEST(Surface, EnclosedMeasureOfSphereConvergesWithSecondOrder) {
  const double exact = 4 * std::numbers::pi / 3;
  const double coarse = exact - enclosed_measure(unit_sphere(3)), fine = exact - enclosed_measure(unit_sphere(4));
  EXPECT_GT(fine, 0);
  EXPECT_NEAR(coarse / fine, 4, 0.1);
}

TEST(Surface, NormalsOfClosedSurfacesSumUpToZeroAndPointOutward) {
  const Surface<3> s = torus(0.7, 0.2, 20, 10);
  Vec<3> sum = Vec<3>::Zero();
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) sum += facet_normal(s, f);
  EXPECT_LT(sum.norm(), 1e-14);
  EXPECT_GT(enclosed_measure(s), 0);
  const Surface<2> p = polygon(7, [](double t) { return 1 + 0.3 * std::sin(2 * t); });
  for (Index f = 0; f < 7; ++f) EXPECT_GT(facet_normal(p, f).dot(p.vertices[p.facets[f][0]]), 0);
}

}  // namespace
}  // namespace shellmatch
