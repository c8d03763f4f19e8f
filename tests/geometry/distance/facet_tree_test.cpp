// Many points at once against one at a time; signed_distance_test.cpp compares these with brute force.
#include "geometry/distance/facet_tree.h"

#include "geometry/distance/nearest_facets.h"
#include "geometry/distance/signed_distance.h"
#include "geometry/surface/facet_point.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace shellmatch {
namespace {

using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <int Dim>
void expect_same(const Surface<Dim>& surface, const std::vector<Vec<Dim>>& points) {
  const FacetTree<Dim> tree(surface);
  std::vector<Index> facets(points.size(), -7);
  tree.nearest(points, facets);
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_EQ(facets[i], tree.nearest(points[i])) << points[i].transpose();
}

/// Points along a line through the surface, near each other.
template <int Dim>
std::vector<Vec<Dim>> in_a_row(std::size_t n) {
  std::vector<Vec<Dim>> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(Vec<Dim>::Constant(-1.5 + 3.0 * static_cast<double>(i) / static_cast<double>(n)));
  return points;
}

template <int Dim>
void expect_same_everywhere(const Surface<Dim>& surface) {
  for (const std::size_t n : {1, 7, 8, 9, 500}) {
    expect_same<Dim>(
        surface, random_points<Dim>(n, Vec<Dim>::Constant(-2), Vec<Dim>::Constant(2)));  // too far apart for a group
    expect_same<Dim>(surface, in_a_row<Dim>(n));
  }
  expect_same<Dim>(surface, surface.vertices);  // each as near to several facets
  expect_same<Dim>(surface, {});
}

TEST(FacetTree, ManyPointsAreOneAfterTheOther) {
  expect_same_everywhere(
      mapped<3>(unit_sphere(4), [](const Vec<3>& x) { return Vec<3>(x * (1 + 0.3 * std::sin(5 * x.x()))); }));
  expect_same_everywhere(box({0, 0, 0}, {1, 2, 3}));
  expect_same_everywhere(polygon(300, [](double t) { return 1 + 0.4 * std::cos(7 * t); }));
}

TEST(FacetTree, InAnyOrderManyPointsAreOneAfterTheOther) {
  const Surface<3> sphere = unit_sphere(4);
  const FacetTree<3> tree(sphere);
  std::vector<Vec<3>> points = random_points<3>(1000, Vec<3>::Constant(-2), Vec<3>::Constant(2));
  for (const bool is_finite : {true, false}) {
    if (!is_finite) points[500].x() = infinity;
    const std::vector<Index> facets = nearest_facets(tree, points);
    ASSERT_EQ(facets.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) ASSERT_EQ(facets[i], tree.nearest(points[i]));
  }
}

TEST(FacetTree, ReachesWhatIsNearerThanADistance) {
  const SignedDistance<3> sphere(unit_sphere(4));
  const FacetTree<3> tree(sphere.surface());
  for (const Vec<3>& x : random_points<3>(300, Vec<3>::Constant(-2), Vec<3>::Constant(2))) {
    const double distance = std::abs(sphere(x));
    EXPECT_TRUE(tree.reaches(x, 1.001 * distance));
    EXPECT_FALSE(tree.reaches(x, 0.999 * distance));
    const Index some = tree.some_near(x);
    ASSERT_NE(some, no_index);
    EXPECT_LT((closest_point_on_facet(sphere.surface(), some, x).point - x).norm(), distance + 1);
  }
}

TEST(FacetTree, OfManyPointsFindsWhatIsNearerThanTheLimitOfEach) {
  const SignedDistance<3> sphere(unit_sphere(4));
  const FacetTree<3> tree(sphere.surface());
  for (const auto& points : {random_points<3>(300, Vec<3>::Constant(-2), Vec<3>::Constant(2)), in_a_row<3>(300)}) {
    std::vector<double> limits;
    for (std::size_t i = 0; i < points.size(); ++i)
      limits.push_back(std::abs(sphere(points[i])) * (i % 3 == 0 ? 0.999 : i % 3 == 1 ? 1.001 : infinity));
    std::vector<Index> facets(points.size());
    tree.nearest_within(points, limits, facets);
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_EQ(facets[i], i % 3 == 0 ? no_index : tree.nearest(points[i])) << i;
  }
}

TEST(FacetTree, WhatIsNotFiniteSpoilsNoOtherPoint) {
  const Surface<3> sphere = unit_sphere(3);
  const FacetTree<3> tree(sphere);
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN(), 1e200}) {
    std::vector<Vec<3>> points = in_a_row<3>(16);
    points[3].y() = bad;
    std::vector<Index> facets(points.size());
    tree.nearest(points, facets);
    EXPECT_EQ(facets[3], no_index);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(facets[i], tree.nearest(points[i])) << bad << " " << i;
  }
}

TEST(SignedDistance, OfManyPointsIsThatOfEach) {
  const SignedDistance<3> distance(
      mapped<3>(unit_sphere(4), [](const Vec<3>& x) { return Vec<3>(x * (1 + 0.2 * std::cos(4 * x.y()))); }));
  const std::vector<Vec<3>> points = random_points<3>(300, {-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5});
  std::vector<double> distances(points.size());
  distance(points, distances);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(distances[i], distance(points[i]));
}

}  // namespace
}  // namespace shellmatch
