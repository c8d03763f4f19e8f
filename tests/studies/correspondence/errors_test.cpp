// Errors of known correspondences: none, turned spheres against great circles, components, units.
#include "tests/studies/correspondence/errors.h"
#include "alignment/spectrum/edge_graph.h"
#include "base/error.h"
#include "geometry/generate/round.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace shellmatch {
namespace {

std::vector<Index> all_of(const Surface<3>& surface) {
  std::vector<Index> all(surface.vertices.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TEST(CorrespondenceError, WhatEndsWhereItBelongsHasNone) {
  const Surface<3> torus = test::torus(2, 0.7, 24, 12);
  const std::vector<Index> all = all_of(torus);
  EXPECT_EQ(nearest_vertices(torus.vertices, torus.vertices), all);
  for (const double e : geodesic_errors(torus, all, all)) EXPECT_EQ(e, 0);
  for (const double e : euclidean_errors(torus.vertices, torus.vertices, all)) EXPECT_EQ(e, 0);
}

TEST(CorrespondenceError, ASphereTurnedByASymmetryOfItsVerticesEndsAGreatCircleAway) {
  // A fifth of a turn about a vertex of the icosahedron carries the vertices of its subdivision onto each other.
  Surface<3> sphere = geodesic_sphere(12);
  const double radius = 3;
  for (Vec<3>& x : sphere.vertices) x *= radius;
  const double angle = 2 * std::numbers::pi / 5;
  const Vec<3> axis = sphere.vertices[0].normalized();
  const Mat<3> turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  std::vector<Vec<3>> ends;
  for (const Vec<3>& x : sphere.vertices) ends.push_back(turn * x);
  const std::vector<Index> nearest = nearest_vertices(sphere.vertices, ends), all = all_of(sphere);
  for (std::size_t v = 0; v < ends.size(); ++v)
    ASSERT_LT((sphere.vertices[nearest[v]] - ends[v]).norm(), 1e-9) << "the icosahedron lies otherwise";
  const std::vector<double> errors = geodesic_errors(sphere, nearest, all);
  double sum = 0, exact_sum = 0;
  for (std::size_t v = 0; v < ends.size(); ++v) {
    // By the chord: a cosine near 1 does not tell small angles apart.
    const double exact = 2 * std::asin(std::min(1.0, (ends[v] - sphere.vertices[v]).norm() / (2 * radius))) /
                         std::sqrt(4 * std::numbers::pi);
    // Chords are a little shorter than arcs. Where triangles are equilateral paths along edges are at most 2 / sqrt(3)
    // of the way, and these are not quite.
    EXPECT_GE(errors[v], 0.999 * exact - 1e-12);
    EXPECT_LE(errors[v], 1.2 * exact + 1e-12);
    sum += errors[v];
    exact_sum += exact;
  }
  EXPECT_GT(sum / exact_sum, 1);
  EXPECT_LT(sum / exact_sum, 1.1);
  const std::vector<double> straight = euclidean_errors(sphere.vertices, ends, all);
  for (std::size_t v = 0; v < ends.size(); ++v)
    EXPECT_NEAR(straight[v], (ends[v] - sphere.vertices[v]).norm() / bounding_box(sphere.vertices).diagonal(), 1e-14);
}

TEST(CorrespondenceError, AnotherComponentIsInfinitelyFar) {
  const Surface<3> sphere = test::unit_sphere(1);
  const auto n = static_cast<Index>(sphere.vertices.size());
  const std::vector<double> errors =
      geodesic_errors(test::joined(sphere, sphere), std::vector<Index>{0, n}, std::vector<Index>{n, n});
  EXPECT_TRUE(std::isinf(errors[0]));
  EXPECT_EQ(errors[1], 0);
}

TEST(CorrespondenceError, ATemplateWithoutAreaIsRefused) {
  const std::vector<Index> first{0};
  EXPECT_THROW(geodesic_errors({{Vec<3>::Zero()}, {}}, first, first), InputError);
  EXPECT_THROW(euclidean_errors(std::vector<Vec<3>>{Vec<3>::Zero()}, std::vector<Vec<3>>{Vec<3>::Zero()}, first),
               InputError);
}

TEST(EdgeGraph, ADistanceIsTheOneOfAllDistances) {
  const Surface<3> surface = test::torus(2, 0.7, 24, 12);
  const EdgeGraph graph(surface);
  const std::vector<double> distances = graph.distances_from(17);
  for (Index v = 0; v < 288; ++v) EXPECT_EQ(graph.distance(17, v), distances[v]);
}

}  // namespace
}  // namespace shellmatch
