// Signed functions against brute force, and what the mesher of zero levels promises.
#include "base/error.h"
#include "geometry/generate/hand.h"
#include "geometry/implicit/mesh_implicit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shellmatch {
namespace {

Vec<3> random_point(std::mt19937& generator, double min, double max) {
  std::uniform_real_distribution<double> u(min, max);
  return {u(generator), u(generator), u(generator)};
}

TEST(SmoothUnion, IsExactApartAndTwiceDifferentiableAtTheSeam) {
  EXPECT_EQ(smooth_union(0.1, 0.3, 0.2), 0.1);
  EXPECT_EQ(smooth_union(0.3, 0.1, 0.2), 0.1);
  EXPECT_NEAR(smooth_union(0.2, 0.2, 0.3), 0.2 - 0.05, 1e-15);
  // One-sided second differences along a at the three seams (difference -width, 0, width) agree to first
  // order.
  const double width = 0.3, b = 0.5, h = 1e-4;
  for (const double a : {b - width, b, b + width}) {
    const auto f = [&](double x) { return smooth_union(x, b, width); };
    const double left = (f(a) - 2 * f(a - h) + f(a - 2 * h)) / (h * h),
                 right = (f(a + 2 * h) - 2 * f(a + h) + f(a)) / (h * h);
    EXPECT_NEAR(left, right, 3 * 4 * h / (width * width)) << a;
    EXPECT_NEAR((f(a) - f(a - h)) / h, (f(a + h) - f(a)) / h, 4 * h / width) << a;
  }
}

TEST(RoundedCone, IsTheDistanceToTheUnionOfItsBalls) {
  const Vec<3> a(0.2, 0.3, 0.4), b(0.7, 0.5, 0.3);
  std::mt19937 generator(1);
  for (int i = 0; i < 200; ++i) {
    const Vec<3> x = random_point(generator, 0, 1);
    double least = 1e300;
    for (int k = 0; k <= 4000; ++k) {
      const double t = k / 4000.0;
      least = std::min(least, (x - (1 - t) * a - t * b).norm() - (0.15 - 0.1 * t));
    }
    // Inside, the least of the balls' functions is a bound on the distance that the hull attains too.
    EXPECT_NEAR(rounded_cone(x, a, b, 0.15, 0.05), least, 1e-6);
  }
}

TEST(RoundedPlate, IsTheDistanceOutside) {
  const std::array<Vec<2>, 3> triangle{Vec<2>(0, 0), Vec<2>(0.5, 0.1), Vec<2>(0.1, 0.4)};
  std::mt19937 generator(2);
  for (int i = 0; i < 50; ++i) {
    const Vec<3> x = random_point(generator, -0.3, 0.7);
    double least = 1e300;
    for (int p = 0; p <= 200; ++p)
      for (int q = 0; p + q <= 200; ++q)
        for (int z = -4; z <= 4; ++z) {
          const Vec<2> y =
              triangle[0] + p / 200.0 * (triangle[1] - triangle[0]) + q / 200.0 * (triangle[2] - triangle[0]);
          least = std::min(least, (x - Vec<3>(y.x(), y.y(), 0.01 * z)).norm());
        }
    if (least > 0.02) {
      EXPECT_NEAR(rounded_plate(x, triangle, 0.04, 0.02), least - 0.02, 1e-3);
    }
  }
}

TEST(Ellipsoid, VanishesOnTheSurfaceWithUnitSlope) {
  const Vec<3> semi(0.3, 0.1, 0.2);
  std::mt19937 generator(3);
  for (int i = 0; i < 50; ++i) {
    const Vec<3> x = semi.cwiseProduct(random_point(generator, -1, 1).normalized());
    EXPECT_NEAR(ellipsoid_function(x, semi), 0, 1e-15);
    EXPECT_NEAR(implicit_gradient([&](const Vec<3>& y) { return ellipsoid_function(y, semi); }, x).norm(), 1, 1e-6);
  }
  EXPECT_LT(ellipsoid_function(Vec<3>::Zero(), semi), 0);
}

TEST(MeshImplicit, VerticesAreOnTheZeroLevel) {
  const Hand hand(HandOptions{});
  for (const Vec<3>& x : mesh_implicit(hand, 0.01, "hand").vertices) EXPECT_LT(std::abs(hand(x)), 1e-9);
}

TEST(MeshImplicit, EdgesHaveTheLengthAskedForAndNormalsPointOutward) {
  const ImplicitFunction ball = [](const Vec<3>& x) { return (x - Vec<3>::Constant(0.5)).norm() - 0.3; };
  for (const double edge : {0.04, 0.02, 0.01}) {
    const Surface<3> s = mesh_implicit(ball, edge, "ball");
    double sum = 0;
    for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) {
      const auto& [a, b, c] = s.facets[f];
      sum += (s.vertices[b] - s.vertices[a]).norm() / s.facets.size();
      EXPECT_GT(facet_normal(s, f).normalized().dot((s.vertices[a] - Vec<3>::Constant(0.5)) / 0.3), 0.9);
    }
    EXPECT_NEAR(sum / edge, 1, 0.1);
  }
}

TEST(MeshImplicit, TwoSheetsCloserThanTheEdgesAreNotGlued) {
  // A shell between two spheres: two closed parts, whatever the resolution of the gap.
  for (const double gap : {0.06, 0.04, 0.03}) {
    const Surface<3> s =
        mesh_implicit([&](const Vec<3>& x) { return std::abs((x - Vec<3>(0.5, 0.51, 0.49)).norm() - 0.3) - 0.5 * gap; },
                      0.02, "shell");
    EXPECT_TRUE(is_closed_manifold(s));
    EXPECT_EQ(static_cast<int>(s.vertices.size()) - static_cast<int>(s.facets.size()) / 2, 4);
  }
}

TEST(MeshImplicit, TooCoarseAnEdgeIsAnError) {
  // Nothing of a ball smaller than the lattice's cubes is seen.
  EXPECT_THROW(mesh_implicit([](const Vec<3>& x) { return (x - Vec<3>(0.512, 0.5, 0.5)).norm() - 1e-4; }, 0.03, "dot"),
               InputError);
}

TEST(ClosedManifold, HolesAndPinchesAreSeen) {
  const ImplicitFunction ball = [](const Vec<3>& x) { return (x - Vec<3>::Constant(0.5)).norm() - 0.2; };
  const Surface<3> whole = mesh_implicit(ball, 0.05, "ball");
  EXPECT_TRUE(is_closed_manifold(whole));
  Surface<3> open = whole;
  open.facets.pop_back();
  EXPECT_FALSE(is_closed_manifold(open));
  Surface<3> turned = whole;
  std::swap(turned.facets[0][0], turned.facets[0][1]);
  EXPECT_FALSE(is_closed_manifold(turned));
  // Two balls that share a single vertex.
  Surface<3> pinched = whole;
  const auto n = static_cast<Index>(whole.vertices.size());
  pinched.vertices.insert(pinched.vertices.end(), whole.vertices.begin() + 1, whole.vertices.end());
  for (const auto& f : whole.facets) {
    std::array<Index, 3> g = f;
    for (Index& v : g) v = v == 0 ? 0 : v + n - 1;
    pinched.facets.push_back(g);
  }
  EXPECT_FALSE(is_closed_manifold(pinched));
}

}  // namespace
}  // namespace shellmatch
