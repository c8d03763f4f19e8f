#include "geometry/surface/topology.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

TEST(Topology, CountsComponentsAndHandles) {
  const Surface<3> ring = torus(0.7, 0.2, 20, 10), ball = unit_sphere(2);
  EXPECT_EQ(topology(ball).n_components, 1u);
  EXPECT_EQ(topology(ball).genus, 0);
  EXPECT_EQ(topology(ring).genus, 1);
  const Topology both = topology(joined(joined(ring, ring), ball));
  EXPECT_EQ(both.n_components, 3u);
  EXPECT_EQ(both.genus, 2);
}

TEST(Topology, LeavesOutSmallComponents) {
  const Surface<3> ball = unit_sphere(2),
                   crumb = mapped<3>(torus(0.7, 0.2, 20, 10), [](const Vec<3>&x) { return Vec<3>(0.01 * x); });
  const Surface<3> both = joined(ball, crumb);
  EXPECT_EQ(topology(both, 1e-6).n_components, 2u);
  EXPECT_EQ(topology(both, 1e-6).genus, 1);
  EXPECT_EQ(topology(both, 1e-3).n_components, 1u);
  EXPECT_EQ(topology(both, 1e-3).genus, 0);
  EXPECT_EQ(topology(both, 1e-3).n_vertices, ball.vertices.size());
}

TEST(Topology, CountsClosedCurvesAndNoVertexWithoutFacet) {
  const Surface<2> square = polygon(4, [](double) { return 1.0; });
  Surface<2> two = joined(square, square);
  two.vertices.emplace_back(9, 9);
  EXPECT_EQ(topology(two).n_components, 2u);
  EXPECT_EQ(topology(two).n_vertices, 8u);
  EXPECT_EQ(topology(two).genus, 0);
}

}  // namespace
}  // namespace shellmatch
