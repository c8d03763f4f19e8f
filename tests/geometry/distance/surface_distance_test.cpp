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

TEST(SurfaceDistance, StatisticsOfWeightedValues) {
  const std::vector<double> values{3, 1, 2, 9}, weights{1, 17.5, 1.5, 0};
  const DistanceStatistics s = weighted_statistics(values, weights);
  EXPECT_DOUBLE_EQ(s.mean, 23.5 / 20);
  EXPECT_EQ(s.p95, 2);  // 19 of 20
  EXPECT_EQ(s.max, 9);  // seen, though it counts for nothing
  const DistanceStatistics alike = weighted_statistics(values, {0, 0, 0, 0}), unweighted = statistics(values);
  EXPECT_EQ(alike.mean, unweighted.mean);
  EXPECT_EQ(alike.p95, unweighted.p95);
  EXPECT_TRUE(std::isnan(weighted_statistics({}, {}).mean));
}

TEST(SurfaceDistance, IsUnsigned) {
  const SignedDistance<3> cube(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(distances_to<3>({{0.5, 0.5, 0.75}, {0.5, 0.5, 1.25}}, cube), (std::vector<double>{0.25, 0.25}));
  EXPECT_EQ(distances_to<3>({{0.5, 0.5, 0.75}, {0.5, 0.5, 1.25}}, cube.surface()), (std::vector<double>{0.25, 0.25}));
  EXPECT_THROW(distances_to<3>({{0.5, std::nan(""), 0.75}}, cube.surface()), std::logic_error);
  EXPECT_THROW(distances_to<3>({{0.5, 0.5, 0.75}}, Surface<3>()), std::logic_error);
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
    for (const double value : {s.mean, s.p95, s.max}) EXPECT_NEAR(value, expected, h * h * large / 2 / diagonal);
  }
}

// Every third of the 2562 vertices, in both directions: the statistics hardly change, and the farthest point may be
// missed.
TEST(SurfaceDistance, OfManyPointsSomeAreEnough) {
  const Surface<3> inner = unit_sphere(4);
  const Surface<3> outer = mapped<3>(inner, [](const Vec<3>& x) { return Vec<3>(x * (1.1 + 0.05 * x.z())); });
  const MatchQuality<3> all = match_quality(inner, SignedDistance<3>(outer)),
                        some = match_quality(inner, SignedDistance<3>(outer), {}, 1, 1000);
  EXPECT_NE(some.template_to_deformed.mean, all.template_to_deformed.mean);
  EXPECT_NEAR(some.template_to_deformed.mean, all.template_to_deformed.mean, 0.02 * all.template_to_deformed.mean);
  EXPECT_NEAR(some.deformed_to_template.mean, all.deformed_to_template.mean, 0.02 * all.deformed_to_template.mean);
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

/// A closed band around y = 0 from x = 0 to `length`, its side y = 0 cut into pieces at some x.
Surface<2> slab(double length, const std::vector<double>& cuts) {
  Surface<2> s{{{length, 0}, {length, 1}, {0, 1}, {0, 0}}, {{0, 1}, {1, 2}, {2, 3}}};
  Index last = 3;
  for (const double x : cuts) {
    s.vertices.emplace_back(x, 0);
    s.facets.push_back({last, static_cast<Index>(s.vertices.size()) - 1});
    last = s.facets.back()[1];
  }
  s.facets.push_back({last, 0});
  return s;
}

// Rows of vertices at one end of a side, which is 0.1 too low there: they weigh no more than what they stand for.
TEST(SurfaceDistance, DoesNotDependOnWhereAMeshIsDense) {
  std::vector<double> few, many;
  for (int i = 1; i < 400; ++i) few.push_back(0.01 * i);
  for (int i = 1; i < 4000; ++i)
    if (i < 1000 || i % 10 == 0) many.push_back(0.001 * i);
  const auto lowered = [](const Vec<2>& x) { return Vec<2>(x.x(), x.y() == 0 && x.x() < 1 ? -0.1 : x.y()); };
  const SignedDistance<2> straight(slab(4, few));
  const MatchQuality<2> sparse = match_quality(mapped<2>(slab(4, few), lowered), straight),
                        dense = match_quality(mapped<2>(slab(4, many), lowered), straight);
  EXPECT_NEAR(dense.deformed_to_template.mean, sparse.deformed_to_template.mean,
              0.02 * sparse.deformed_to_template.mean);
  EXPECT_EQ(dense.deformed_to_template.max, sparse.deformed_to_template.max);
}

// All vertices of the template lie on the deformed surface, which has a notch in the middle of one of its sides.
TEST(SurfaceDistance, SeesWhatLiesWithinALargeFacet) {
  const Surface<2> plain = slab(4, {});
  const Surface<2> notched = mapped<2>(
      slab(4, {1.5, 2, 2.5}), [](const Vec<2>& x) { return Vec<2>(x.x(), x.x() == 2 && x.y() == 0 ? 0.4 : x.y()); });
  const double diagonal = std::hypot(4, 1);
  EXPECT_EQ(match_quality(notched, SignedDistance<2>(plain)).template_to_deformed.max, 0);
  const MatchQuality<2> q = match_quality(notched, SignedDistance<2>(plain), {}, 0.01);
  // At the mouth's middle the nearest point is on a flank of slope 0.4 / 0.5.
  EXPECT_NEAR(q.template_to_deformed.max * diagonal, 0.4 * 0.5 / std::hypot(0.4, 0.5), 0.005);
  EXPECT_NEAR((q.farthest_of_template - Vec<2>(2, 0)).norm(), 0, 0.01);
}

TEST(SurfaceDistance, HasTheSameBitsWhateverTheNumberOfThreads) {
  const SignedDistance<3> sphere(unit_sphere(3));
  const auto points = query_points(sphere.surface(), 2000);
  set_n_threads(1);
  const auto one = distances_to(points, sphere);
  EXPECT_EQ(distances_to(points, sphere.surface()), one);
  set_n_threads(0);
  EXPECT_EQ(distances_to(points, sphere), one);
}

}  // namespace
}  // namespace shellmatch
