// Polygons out of segments; smoothed curves of circles, whose turning and length are known.
#include "alignment/outline/closed_curve.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

std::vector<Vec<2>> points_of(const Surface<2>& outline, const std::vector<Index>& polygon) {
  std::vector<Vec<2>> points;
  for (const Index v : polygon) points.push_back(outline.vertices[v]);
  return points;
}

TEST(ClosedPolygons, AreFoundInTheDirectionOfTheirSegmentsAndOpenLinesAreLeftOut) {
  const Surface<2> ring = test::polygon(7, [](double) { return 2.0; });
  Surface<2> outline = test::joined(ring, test::reversed(test::polygon(5, [](double) { return 1.0; })));
  const auto open = static_cast<Index>(outline.vertices.size());
  for (int k = 0; k < 5; ++k) outline.vertices.push_back(Vec<2>(5 + k, 0));
  for (Index k = 0; k < 4; ++k) outline.facets.push_back({open + k, open + k + 1});
  std::swap(outline.facets[1], outline.facets[9]);
  const std::vector<std::vector<Index>> polygons = closed_polygons(outline);
  ASSERT_EQ(polygons.size(), 2u);
  EXPECT_EQ(polygons[0], (std::vector<Index>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(polygons[1].size(), 5u);
  EXPECT_FALSE(smoothed_curve(points_of(outline, polygons[0]), 16, 0).is_hole);
  EXPECT_TRUE(smoothed_curve(points_of(outline, polygons[1]), 16, 0).is_hole);
}

TEST(ClosedCurve, OfACircleTurnsEvenlyWhateverTheSpacingOfItsVertices) {
  const double radius = 3;
  std::vector<Vec<2>> polygon;
  for (int k = 0; k < 900; ++k) {
    const double share = k / 900.0, t = 2 * std::numbers::pi * (share + 0.1 * std::sin(2 * std::numbers::pi * share));
    polygon.push_back(radius * Vec<2>(std::cos(t), std::sin(t)));
  }
  const std::size_t n = 100;
  const double deviation = 0.01;
  const ClosedCurve curve = smoothed_curve(polygon, n, deviation);
  // A Gaussian of standard deviation s, in radians, shrinks a circle by exp(-s^2 / 2).
  const double shrunk = radius * std::exp(-0.5 * std::pow(2 * std::numbers::pi * deviation, 2));
  EXPECT_NEAR(curve.length, 2 * std::numbers::pi * shrunk, 1e-3);
  ASSERT_EQ(curve.size(), n);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(curve.points[i].norm(), shrunk, 2e-4);
    EXPECT_NEAR((curve.points[i] - curve.points[(i + 1) % n]).norm(), curve.length / n, 1e-3);
    EXPECT_GT(curve.normals[i].dot(curve.points[i].normalized()), 0.9999);
    EXPECT_NEAR(curve.on_input[i].norm(), radius, 1e-4);
    EXPECT_GT(curve.on_input[i].normalized().dot(curve.points[i].normalized()), 0.9999);
    // Chords of 2, 5 and 10 % of the circle turn by as much of 2 pi.
    EXPECT_NEAR(curve.turning[0][i], 0.04, 1e-3);
    EXPECT_NEAR(curve.turning[1][i], 0.10, 1e-3);
    EXPECT_NEAR(curve.turning[2][i], 0.20, 1e-3);
  }
}

TEST(ClosedCurve, LosesItsTeethButTheyStayOnTheInput) {
  const auto toothed = [](double t) { return 1 + 0.03 * std::sin(37 * t); };
  const Surface<2> outline = test::polygon(2000, toothed);
  const ClosedCurve curve = smoothed_curve(outline.vertices, 200, 0.02);
  double range = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_NEAR(curve.points[i].norm(), 1, 0.012);
    range = std::max(range, std::abs(curve.on_input[i].norm() - 1));
    EXPECT_LT((curve.on_input[i] - curve.points[i]).norm(), 0.06);
  }
  EXPECT_GT(range, 0.02);
}

}  // namespace
}  // namespace shellmatch
