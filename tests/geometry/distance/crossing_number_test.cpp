#include "geometry/distance/winding_number.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace shellmatch {
namespace {

using namespace test;

TEST(CrossingNumber, IsTheWindingNumber) {
  Surface<3> other = unit_sphere(3);
  for (Vec<3>& x : other.vertices) x = 0.8 * x + Vec<3>(0.7, 0.1, -0.2);
  const Surface<3> s = joined(joined(unit_sphere(3), other), reversed(torus(0.4, 0.15, 30, 16)));
  const CrossingNumber number(s);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1.6, 1.6);
  std::array<int, 4> counts{};
  for (int i = 0; i < 2000; ++i) {
    const Vec<3> x(coordinate(random), coordinate(random), coordinate(random));
    const double winding = winding_number<3>(s, x);
    EXPECT_NEAR(number(x), winding, 1e-9) << x.transpose();
    ++counts[static_cast<std::size_t>(std::clamp(static_cast<int>(std::lround(winding)), -1, 2) + 1)];
  }
  for (const int i : {1, 2, 3}) EXPECT_GT(counts[static_cast<std::size_t>(i)], 20) << i;
}

TEST(CrossingNumber, OfSurfacesThatFaceInward) {
  const Surface<3> inward = reversed(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(CrossingNumber(inward)({0.3, 0.4, 0.5}), -1);
  EXPECT_EQ(CrossingNumber(inward)({0.3, 0.4, 1.5}), 0);
}

// From the centre, every direction of a box's or an octahedron's symmetry meets edges.
TEST(CrossingNumber, FromTheCentreOfSymmetricBodies) {
  EXPECT_EQ(CrossingNumber(box({-1, -1, -1}, {1, 1, 1}))({0, 0, 0}), 1);
  EXPECT_EQ(CrossingNumber(unit_sphere(0))({0, 0, 0}), 1);
}

}  // namespace
}  // namespace shellmatch
