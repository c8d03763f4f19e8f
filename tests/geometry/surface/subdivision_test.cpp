#include "geometry/surface/subdivision.h"

#include "geometry/surface/topology.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {
namespace {

using namespace test;

double longest_edge(const Surface<3>& s) {
  double longest = 0;
  for (const auto& facet : s.facets)
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, (s.vertices[facet[k]] - s.vertices[facet[(k + 1) % 3]]).norm());
  return longest;
}

/// The same surface, with the same orientation and without cracks.
void expect_same(const Surface<3>& fine, const Surface<3>& before) {
  EXPECT_NEAR(boundary_measure(fine), boundary_measure(before), 1e-12);
  EXPECT_NEAR(enclosed_measure(fine), enclosed_measure(before), 1e-12);
  EXPECT_EQ(topology(fine).genus, topology(before).genus) << "edges are cut for both their facets";
  EXPECT_EQ(topology(fine).n_components, topology(before).n_components);
  EXPECT_EQ(topology(fine).n_vertices, fine.vertices.size());
  EXPECT_TRUE(std::equal(before.vertices.begin(), before.vertices.end(), fine.vertices.begin()))
      << "vertices keep their numbers";
}

TEST(Subdivision, LeavesNoLongEdgeAndTheSameSurface) {
  const Surface<3> cube = box({0, 0, 0}, {1, 1, 1}), bar = box({0, 0, 0}, {4, 0.1, 0.02}),
                   ring = torus(0.7, 0.2, 12, 5);
  for (const auto& [surface, length] : {std::pair{cube, 0.3}, {cube, 1.2}, {bar, 0.3}, {bar, 0.05}, {ring, 0.2}}) {
    const Surface<3> fine = subdivided(surface, length);
    EXPECT_LE(longest_edge(fine), length);
    EXPECT_GT(fine.facets.size(), surface.facets.size());
    expect_same(fine, surface);
  }
  EXPECT_EQ(subdivided(ring, 1).facets, ring.facets);
}

TEST(Subdivision, CutsOnlyEdgesThatAreLong) {
  // Of the cube the six diagonals, each of which has two facets.
  EXPECT_EQ(subdivided(box({0, 0, 0}, {1, 1, 1}), 1.2).facets.size(), 24u);
  Surface<3> ball = unit_sphere(1);
  const Surface<3> before = ball;
  EXPECT_TRUE(cut_long_edges(ball, 0));
  EXPECT_EQ(ball.facets.size(), 4 * before.facets.size());
  expect_same(ball, before);
  EXPECT_FALSE(cut_long_edges(ball, 1));
}

TEST(Subdivision, CurvesKeepTheirLength) {
  const Surface<2> square = polygon(4, [](double) { return std::sqrt(0.5); });
  const Surface<2> fine = subdivided(square, 0.3);
  EXPECT_EQ(fine.facets.size(), 16u);
  EXPECT_NEAR(boundary_measure(fine), 4, 1e-14);
  for (std::size_t f = 0; f < fine.facets.size(); ++f)
    EXPECT_NEAR(facet_measure(fine, static_cast<Index>(f)), 0.25, 1e-14);
}

}  // namespace
}  // namespace shellmatch
