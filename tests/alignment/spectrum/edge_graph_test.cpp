// Distances along edges against the shortest walks that exist, samples that spread.
#include "alignment/spectrum/edge_graph.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace shellmatch {
namespace {

TEST(EdgeGraph, DistancesAreTheFixedPointOfAllEdges) {
  // Lengths of shortest paths are the only function that vanishes at the source alone and equals elsewhere the least
  // sum of a neighbour's value and the edge to it.
  const Surface<3> surface = test::torus(2, 0.7, 24, 12);
  const std::vector<double> distances = EdgeGraph(surface).distances_from(17);
  std::vector<double> least(distances.size(), 1e300);
  for (const auto& facet : surface.facets)
    for (int k = 0; k < 3; ++k)
      for (const auto& [a, b] : {std::pair(facet[k], facet[(k + 1) % 3]), std::pair(facet[(k + 1) % 3], facet[k])})
        least[a] = std::min(least[a], distances[b] + (surface.vertices[a] - surface.vertices[b]).norm());
  least[17] = 0;
  // Lengths of edges may be rounded differently here and there.
  for (std::size_t v = 0; v < least.size(); ++v) EXPECT_NEAR(distances[v], least[v], 1e-13) << v;
}

TEST(EdgeGraph, AnotherComponentIsOutOfReach) {
  const Surface<3> sphere = test::unit_sphere(1);
  const EdgeGraph graph(test::joined(sphere, sphere));
  const auto n = static_cast<Index>(sphere.vertices.size());
  const std::vector<double> distances = graph.distances_from(0);
  for (Index v = 0; v < 2 * n; ++v) EXPECT_EQ(std::isfinite(distances[v]), v < n);
}

TEST(FarthestPoints, EachIsTheFarthestFromThoseBefore) {
  const Surface<3> surface = test::torus(2, 0.7, 24, 12);
  const EdgeGraph graph(surface);
  const std::vector<Index> samples = farthest_point_samples(graph, 3, 20);
  ASSERT_EQ(samples.size(), 20u);
  EXPECT_EQ(samples[0], 3);
  std::vector<double> to_samples = graph.distances_from(3);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    EXPECT_EQ(to_samples[samples[i]], *std::max_element(to_samples.begin(), to_samples.end()));
    const std::vector<double> more = graph.distances_from(samples[i]);
    for (std::size_t v = 0; v < more.size(); ++v) to_samples[v] = std::min(to_samples[v], more[v]);
  }
}

TEST(FarthestPoints, AllVerticesOfASmallSurface) {
  const Surface<3> surface = test::unit_sphere(1);
  const std::vector<Index> samples = farthest_point_samples(EdgeGraph(surface), 0, 1000);
  EXPECT_EQ(samples.size(), surface.vertices.size());
  EXPECT_EQ(std::set<Index>(samples.begin(), samples.end()).size(), samples.size());
}

}  // namespace
}  // namespace shellmatch
