#include "geometry/surface/facet_edges.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

namespace shellmatch {
namespace {

using namespace test;
using Facets = std::vector<std::array<Index, 3>>;

auto key(const FacetEdge& e) { return std::tie(e.low, e.high, e.facet, e.begin); }

TEST(FacetEdges, AreThoseOfAllTrianglesInOrder) {
  std::mt19937 random(7);
  Facets facets;
  for (int f = 0; f < 500; ++f) {
    // Half of them at one hub, and some with equal corners.
    const auto corner = [&] { return static_cast<Index>(random() % 30); };
    facets.push_back({f % 2 == 0 ? 3 : corner(), corner(), corner()});
  }
  std::vector<FacetEdge> expected;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Index a = facets[f][k], b = facets[f][(k + 1) % 3];
      if (a != b) expected.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(f), k});
    }
  const auto in_order = [](const FacetEdge& e, const FacetEdge& f) { return key(e) < key(f); };
  std::sort(expected.begin(), expected.end(), in_order);
  std::vector<FacetEdge> found = sorted_edges(facets, 30);
  const auto without_begin = [](const FacetEdge& e, const FacetEdge& f) {
    return std::tie(e.low, e.high, e.facet) < std::tie(f.low, f.high, f.facet);
  };
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), without_begin));
  std::sort(found.begin(), found.end(), in_order);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(key(found[i]), key(expected[i])) << i;
}

TEST(FacetEdges, TellWhatBoundsFromWhatDoesNot) {
  const Surface<3> ball = unit_sphere(2), ring = torus(0.7, 0.2, 20, 10);
  EXPECT_TRUE(is_oriented_manifold(ball.facets, ball.vertices.size()));
  EXPECT_TRUE(is_oriented_manifold(ring.facets, ring.vertices.size()));
  Facets turned = ball.facets, open = ball.facets, crowded = ball.facets;
  std::swap(turned[5][0], turned[5][1]);
  EXPECT_FALSE(is_oriented_manifold(turned, ball.vertices.size()));
  open.pop_back();
  EXPECT_FALSE(is_oriented_manifold(open, ball.vertices.size()));
  crowded.push_back(crowded[0]);
  EXPECT_FALSE(is_oriented_manifold(crowded, ball.vertices.size()));
  // Two balls that share one vertex.
  Surface<3> two = joined(ball, ball);
  const auto n = static_cast<Index>(ball.vertices.size());
  for (auto& facet : two.facets)
    for (Index& v : facet)
      if (v == n) v = 0;
  EXPECT_FALSE(is_oriented_manifold(two.facets, two.vertices.size()));
  // A triangle whose sides are its own other sides.
  EXPECT_FALSE(is_oriented_manifold({{0, 1, 0}}, 2));
}

TEST(FacetEdges, BordersMayBeAllowed) {
  const auto is_mesh = [](const Facets& facets, std::size_t n) {
    return is_oriented_manifold(facets, n, Border::allowed);
  };
  const Surface<3> ball = unit_sphere(2);
  const std::size_t n = ball.vertices.size();
  EXPECT_TRUE(is_mesh(ball.facets, n));
  // Without all facets at a vertex.
  Facets open = ball.facets;
  const auto at = [](const std::array<Index, 3>& facet, Index v) { return std::ranges::find(facet, v) != facet.end(); };
  std::erase_if(open, [&](const auto& facet) { return at(facet, 7); });
  EXPECT_TRUE(is_mesh(open, n));
  EXPECT_FALSE(is_oriented_manifold(open, n));
  std::swap(open[3][0], open[3][1]);
  EXPECT_FALSE(is_mesh(open, n));
  EXPECT_TRUE(is_mesh({{0, 1, 2}, {0, 2, 3}}, 4));
  EXPECT_FALSE(is_mesh({{0, 1, 2}, {0, 2, 3}, {2, 0, 4}}, 5)) << "three triangles at an edge";
  EXPECT_FALSE(is_mesh({{0, 1, 2}, {0, 3, 4}}, 5)) << "two fans that end";
  EXPECT_FALSE(is_mesh({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}}, 6)) << "one that goes round, and one that ends";
  EXPECT_FALSE(is_mesh({{0, 1, 2}, {0, 1, 0}}, 3));
}

}  // namespace
}  // namespace shellmatch
