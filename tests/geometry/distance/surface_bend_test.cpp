#include "geometry/distance/surface_bend.h"
#include "geometry/generate/round.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

TEST(SurfaceBend, ARigidMotionOfTheSurfaceIsThatOfThePointsBesideIt) {
  const Surface<3> sphere = geodesic_sphere(8);
  const Mat<3> turn = Eigen::AngleAxisd(2, Vec<3>(1, 2, -1).normalized()).toRotationMatrix();
  const auto moved = [&](const Vec<3>& x) { return Vec<3>(turn * x + Vec<3>(3, 0, -1)); };
  std::vector<Vec<3>> bent;
  for (const Vec<3>& x : sphere.vertices) bent.push_back(moved(x));
  const SurfaceBend<3> bend(sphere, bent);
  for (const double radius : {0.5, 0.9, 1.0, 1.7}) {
    const Vec<3> x = radius * Vec<3>(0.3, -0.5, 0.8).normalized();
    EXPECT_NEAR((bend(x) - moved(x)).norm(), 0, 1e-12);
    EXPECT_NEAR((bend.inverse(bend(x)) - x).norm(), 0, 1e-12);
  }
  for (std::size_t v = 0; v < bent.size(); ++v) EXPECT_EQ(bend(sphere.vertices[v]), bent[v]) << v;
}

TEST(SurfaceBend, SpheresThatTouchPart) {
  Surface<3> both = geodesic_sphere(8);
  const std::size_t n = both.vertices.size();
  for (std::size_t v = 0; v < n; ++v) both.vertices.push_back(both.vertices[v] + Vec<3>(2.001, 0, 0));
  for (std::size_t f = 0, n_facets = both.facets.size(); f < n_facets; ++f) {
    auto facet = both.facets[f];
    for (Index& v : facet) v += static_cast<Index>(n);
    both.facets.push_back(facet);
  }
  std::vector<Vec<3>> bent = both.vertices;
  for (std::size_t v = n; v < bent.size(); ++v) bent[v] += Vec<3>(5, 0, 0);
  const SurfaceBend<3> bend(both, bent);
  Surface<3> carried = both;
  bend.apply(carried);
  EXPECT_EQ(carried.vertices, bent);
}

TEST(SurfaceBend, TellsHowFarAnotherSurfaceLies) {
  Surface<3> sphere = geodesic_sphere(8);
  const SurfaceBend<3> bend(sphere, sphere.vertices);
  EXPECT_NEAR(bend.farthest(sphere), 0, 1e-15);
  sphere.vertices.front() *= 1.25;
  EXPECT_NEAR(bend.farthest(sphere), 0.25, 0.01);
  EXPECT_EQ(bend.farthest({}), 0);
}

TEST(SurfaceBend, OutlinesToo) {
  const Surface<2> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
  const SurfaceBend<2> bend(square, {{0, 0}, {0, 1}, {-1, 1}, {-1, 0}});  // a quarter turn
  EXPECT_NEAR((bend(Vec<2>(0.5, -0.25)) - Vec<2>(0.25, 0.5)).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace shellmatch
