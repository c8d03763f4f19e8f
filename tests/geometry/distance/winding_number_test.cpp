#include "geometry/distance/winding_number.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

TEST(WindingNumber, CountsHowOftenClosedSurfacesSurroundAPoint) {
  const Surface<3> outer = box({0, 0, 0}, {1, 1, 1}), inner = box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
  const Vec<3> centre(0.5, 0.45, 0.55), between(0.1, 0.5, 0.5), outside(1.2, 0.5, 0.1);
  const Surface<3> twice = joined(outer, inner), hollow = joined(outer, reversed(inner));
  EXPECT_NEAR(winding_number(twice, centre), 2, 1e-13);
  EXPECT_NEAR(winding_number(twice, between), 1, 1e-13);
  EXPECT_NEAR(winding_number(hollow, centre), 0, 1e-13);
  EXPECT_NEAR(winding_number(hollow, between), 1, 1e-13);
  EXPECT_NEAR(winding_number(hollow, outside), 0, 1e-13);
}

TEST(WindingNumber, InThePlaneToo) {
  const Surface<2> star = polygon(10, [](double t) { return std::cos(5 * t) > 0 ? 1.0 : 0.4; });
  EXPECT_NEAR(winding_number<2>(star, {0.1, 0.1}), 1, 1e-13);
  EXPECT_NEAR(winding_number<2>(star, {-0.8, 0.1}), 0, 1e-13);
  EXPECT_NEAR(winding_number(reversed(star), Vec<2>(0.1, 0.1)), -1, 1e-13);
}

TEST(WindingNumber, OfAnOpenHemisphereIsOneHalfAtItsCentre) {
  Surface<3> half = unit_sphere(2);
  std::erase_if(half.facets, [&](const auto& f) {
    return half.vertices[f[0]].z() + half.vertices[f[1]].z() + half.vertices[f[2]].z() < 0;
  });
  EXPECT_NEAR(winding_number<3>(half, {0, 0, 0}), 0.5, 1e-13);
}

}  // namespace
}  // namespace shellmatch
