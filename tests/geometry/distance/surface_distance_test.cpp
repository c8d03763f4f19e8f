#include "geometry/distance/surface_distance.h"

#include "base/parallel.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

TEST(SurfaceDistance, StatisticsOfKnownValues) {
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  const DistanceStatistics s = statistics(values);
  EXPECT_EQ(s.mean, 50);
  EXPECT_EQ(s.p95, 95);
  EXPECT_EQ(s.max, 100);
  EXPECT_EQ(quantile(values, 0), 0);
  EXPECT_TRUE(std::isnan(statistics({}).mean));
}

TEST(SurfaceDistance, IsUnsigned) {
  const SignedDistance<3> cube(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(distances_to<3>({{0.5, 0.5, 0.75}, {0.5, 0.5, 1.25}}, cube), (std::vector<double>{0.25, 0.25}));
}

TEST(SurfaceDistance, OfConcentricSpheresIsTheDifferenceOfRadii) {
  const double small = 0.3, large = 0.4;
  const Surface<3> inner = mapped<3>(unit_sphere(5), [&](const Vec<3>& x) { return Vec<3>(small * x); });
  const Surface<3> outer = mapped<3>(unit_sphere(5), [&](const Vec<3>& x) { return Vec<3>(large * x); });
  const MatchQuality<3> quality = match_quality(inner, SignedDistance<3>(outer));
  const double diagonal = 2 * large * std::sqrt(3.0), expected = (large - small) / diagonal;
  // The facets lie inside of their spheres by less than h^2 / (2 R).
  const double h = 0.07;
  for (const DistanceStatistics& s : {quality.deformed_to_template, quality.template_to_deformed}) {
    for (const double value : {s.mean, s.p95, s.max})
      EXPECT_NEAR(value, expected, h * h * large / 2 / diagonal);
  }
}

TEST(SurfaceDistance, SeesWhatIsMissingOnOneSideOnly) {
  // The deformed surface is only one of the template's two squares: all of it is covered, the template is
  // not.
  const Surface<2> square = polygon(4, [](double) { return 1.0; });
  const Surface<2> far = mapped<2>(square, [](const Vec<2>& x) { return Vec<2>(x + Vec<2>(5, 0)); });
  const MatchQuality<2> quality = match_quality(square, SignedDistance<2>(joined(square, far)));
  EXPECT_EQ(quality.deformed_to_template.max, 0);
  EXPECT_NEAR(quality.template_to_deformed.max, 5 / std::hypot(7, 2), 1e-15);
  EXPECT_NEAR(quality.uncovered, 0.5, 1e-15);
  EXPECT_EQ(quality.farthest_of_template, Vec<2>(6, 0));
  EXPECT_EQ(match_quality(joined(square, far), SignedDistance<2>(square)).farthest_of_deformed, Vec<2>(6, 0));
  EXPECT_EQ(match_quality(joined(square, far), SignedDistance<2>(square)).uncovered, 0);
}

TEST(SurfaceDistance, HasTheSameBitsWhateverTheNumberOfThreads) {
  const SignedDistance<3> sphere(unit_sphere(3));
  const auto points = query_points(sphere.surface(), 2000);
  set_n_threads(1);
  const auto one = distances_to(points, sphere);
  set_n_threads(0);
  EXPECT_EQ(distances_to(points, sphere), one);
}

}  // namespace
}  // namespace shellmatch
