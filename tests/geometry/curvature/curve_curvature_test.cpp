#include "geometry/curvature/curvature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

// A ring of n points on an ellipse, counter-clockwise.
Surface<2> ellipse(int n, double a, double b) {
  Surface<2> s;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    s.vertices.push_back({a * std::cos(t), b * std::sin(t)});
    s.facets.push_back({i, (i + 1) % n});
  }
  return s;
}

double largest_error(int n, int n_rings) {
  const double a = 3, b = 2;
  const Surface<2> s = ellipse(n, a, b);
  const auto k = curve_curvatures(s, n_rings);
  double worst = 0;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    const double exact = a * b / std::pow(std::hypot(a * std::sin(t), b * std::cos(t)), 3);
    worst = std::max(worst, std::abs(k[i] - exact));
  }
  return worst;
}

TEST(CurveCurvature, SecondOrderOnAnEllipse) {
  for (const int rings : {1, 2, 4}) {
    const double order = std::log2(largest_error(100, rings) / largest_error(200, rings));
    EXPECT_GT(order, 1.8) << rings;
    EXPECT_LT(order, 2.2) << rings;
  }
}

TEST(CurveCurvature, SignFollowsTheOrientation) {
  Surface<2> s = ellipse(60, 2, 2);
  for (const double k : curve_curvatures(s)) EXPECT_NEAR(k, 0.5, 0.01);
  for (auto& [a, b] : s.facets) std::swap(a, b);  // now a hole
  for (const double k : curve_curvatures(s)) EXPECT_NEAR(k, -0.5, 0.01);
}

TEST(CurveCurvature, ExactOnAParabolaAtItsApex) {
  Surface<2> s;
  for (int i = -3; i <= 3; ++i) s.vertices.push_back({-0.1 * i, -0.5 * 3 * 0.01 * i * i});
  s.vertices.push_back({0, -2});
  for (Index i = 0; i < 8; ++i) s.facets.push_back({i, (i + 1) % 8});
  EXPECT_NEAR(curve_curvatures(s, 3)[3], 3, 1e-11);
}

// Through the points (-1, 1), (0, 0) and (3, 1) of the frame along their chord goes z = -2/3 s + 1/3 s^2.
TEST(CurveCurvature, OfUnevenPointsIsThatOfTheirParabolaWithItsSlope) {
  Surface<2> s;
  s.vertices = {{1, -1}, {0, 0}, {-3, -1}, {0, -5}};
  for (Index i = 0; i < 4; ++i) s.facets.push_back({i, (i + 1) % 4});
  EXPECT_NEAR(curve_curvatures(s, 1)[1], 2.0 / 3 / std::pow(1 + 4.0 / 9, 1.5), 1e-14);
}

TEST(CurveCurvature, UnknownWhereTheRingIsTooShort) {
  const Surface<2> s = ellipse(4, 1, 1);
  for (const double k : curve_curvatures(s, 2)) EXPECT_TRUE(std::isnan(k));
  for (const double k : curve_curvatures(s, 1)) EXPECT_FALSE(std::isnan(k));
}

TEST(CurveCurvature, ScalesInversely) {
  const auto one = curve_curvatures(ellipse(50, 2, 1)), large = curve_curvatures(ellipse(50, 2000, 1000));
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(1000 * large[i], one[i], 1e-9);
}

}  // namespace
}  // namespace shellmatch
