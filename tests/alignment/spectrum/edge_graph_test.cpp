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

TEST(EdgeGraph, TheNearestOfSeveralIsThatOfTheLeastDistance) {
  const EdgeGraph graph(test::torus(2, 0.7, 24, 12));
  const std::vector<Index> sources{3, 100, 177, 40};
  constexpr double reach = 2;
  std::vector<std::vector<double>> distances;
  for (const Index source : sources) distances.push_back(graph.distances_from(source));
  const std::vector<std::size_t> nearest = graph.nearest_of(sources, reach);
  std::set<std::size_t> seen;
  for (Index v = 0; v < static_cast<Index>(graph.n_vertices()); ++v) {
    double least = reach;
    for (const auto& from_source : distances) least = std::min(least, from_source[v]);
    seen.insert(nearest[v]);
    if (least == reach) EXPECT_EQ(nearest[v], EdgeGraph::none) << v;
    else EXPECT_NEAR(distances.at(nearest[v])[v], least, 1e-13) << v;
  }
  EXPECT_EQ(seen, (std::set<std::size_t>{0, 1, 2, 3, EdgeGraph::none}));
}

// Two spheres that touch in a vertex of either: neighbours are those of the own sphere.
TEST(NearestAlong, AreTheLeastDistancesAlongTheSurface) {
  const Surface<3> sphere = test::unit_sphere(2);
  Surface<3> beside = sphere;
  const Vec<3> side = sphere.vertices[7] - beside.vertices[0];
  for (Vec<3>& x : beside.vertices) x += side;
  const EdgeGraph graph(test::joined(sphere, beside));
  const auto n = static_cast<Index>(sphere.vertices.size());
  std::vector<Index> vertices = farthest_point_samples(EdgeGraph(sphere), 7, 30);
  for (std::size_t i = 0; i < 5; ++i) vertices.push_back(vertices[i] + n);
  const auto nearest = nearest_along(graph, vertices, 6);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::vector<double> distances = graph.distances_from(vertices[i]);
    std::vector<std::pair<double, std::size_t>> expected;
    for (std::size_t j = 0; j < vertices.size(); ++j)
      if (j != i && std::isfinite(distances[vertices[j]])) expected.emplace_back(distances[vertices[j]], j);
    std::ranges::sort(expected);
    ASSERT_EQ(nearest[i].size(), i < 30 ? 6u : 4u);
    for (std::size_t k = 0; k < nearest[i].size(); ++k) {
      EXPECT_EQ(nearest[i][k].first, expected[k].first);
      EXPECT_EQ(distances[vertices[nearest[i][k].second]], expected[k].first);
    }
  }
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
