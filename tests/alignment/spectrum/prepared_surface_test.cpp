// Surfaces of any size and number of parts become one connected surface of fitting size.
#include "alignment/spectrum/alike_components.h"
#include "alignment/spectrum/prepared_surface.h"
#include "base/error.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace shellmatch {
namespace {

/// Number of edges that have not exactly two facets.
std::size_t n_open_edges(const Surface<3>& surface) {
  std::map<std::pair<Index, Index>, int> facets;
  for (const auto& facet : surface.facets)
    for (int k = 0; k < 3; ++k) {
      const Index a = facet[k], b = facet[(k + 1) % 3];
      ++facets[{std::min(a, b), std::max(a, b)}];
    }
  return static_cast<std::size_t>(
      std::count_if(facets.begin(), facets.end(), [](const auto& e) { return e.second != 2; }));
}

TEST(PreparedSurface, AFittingSurfaceStaysAsItIs) {
  const Surface<3> sphere = test::unit_sphere(4);
  const PreparedSurface prepared = prepare_surface(sphere, {});
  EXPECT_EQ(prepared.surface.vertices, sphere.vertices);
  EXPECT_EQ(prepared.surface.facets, sphere.facets);
  EXPECT_EQ(prepared.share, 1);
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v) EXPECT_EQ(prepared.nearest[v], static_cast<Index>(v));
}

TEST(PreparedSurface, ALargeSurfaceIsSimplifiedAndStaysClosed) {
  const Surface<3> torus = test::torus(2, 0.7, 120, 60);
  AlignmentOptions options;
  options.max_vertices = 1500;
  const PreparedSurface prepared = prepare_surface(torus, options);
  const auto n_vertices = static_cast<double>(prepared.surface.vertices.size());
  EXPECT_NEAR(n_vertices, 1500, 15);
  EXPECT_EQ(n_open_edges(prepared.surface), 0u);
  EXPECT_EQ(prepared.surface.facets.size(), 2 * prepared.surface.vertices.size());  // genus 1, as before
  const double area = test::boundary_measure(torus);
  EXPECT_NEAR(test::boundary_measure(prepared.surface), area, 0.02 * area);
  // The mean area of a facet gives the length of its edges.
  const double edge = std::sqrt(area / static_cast<double>(prepared.surface.facets.size()) * 4 / std::sqrt(3));
  for (std::size_t v = 0; v < torus.vertices.size(); ++v)
    EXPECT_LT((prepared.surface.vertices[prepared.nearest[v]] - torus.vertices[v]).norm(), 1.5 * edge);
}

// Eight times as many vertices as are wanted and more: edges go in passes before they go in order.
TEST(PreparedSurface, AVeryLargeSurfaceKeepsTopologyAndPlace) {
  const Surface<3> torus = test::torus(2, 0.7, 240, 120);
  AlignmentOptions options;
  options.max_vertices = 1500;
  const PreparedSurface prepared = prepare_surface(torus, options);
  EXPECT_NEAR(static_cast<double>(prepared.surface.vertices.size()), 1500, 15);
  EXPECT_EQ(n_open_edges(prepared.surface), 0u);
  EXPECT_EQ(prepared.surface.facets.size(), 2 * prepared.surface.vertices.size());
  const double area = test::boundary_measure(torus);
  EXPECT_NEAR(test::boundary_measure(prepared.surface), area, 0.02 * area);
  EXPECT_NEAR(enclosed_measure(prepared.surface), enclosed_measure(torus), 0.03 * enclosed_measure(torus));
  for (const Vec<3>& x : prepared.surface.vertices)
    EXPECT_NEAR(std::hypot(std::hypot(x.x(), x.y()) - 2, x.z()), 0.7, 0.05);
}

TEST(PreparedSurface, ACoarseSurfaceIsDividedWithoutMoving) {
  const Surface<3> box = test::box({0, 0, 0}, {1, 2, 3});
  const PreparedSurface prepared = prepare_surface(box, {});
  EXPECT_GE(prepared.surface.vertices.size(), n_least_vertices);
  EXPECT_EQ(n_open_edges(prepared.surface), 0u);
  EXPECT_NEAR(test::boundary_measure(prepared.surface), 22, 1e-12);
  EXPECT_NEAR(enclosed_measure(prepared.surface), 6, 1e-12);
  for (std::size_t v = 0; v < box.vertices.size(); ++v)
    EXPECT_EQ(prepared.surface.vertices[prepared.nearest[v]], box.vertices[v]);
}

TEST(PreparedSurface, TheLargestComponentIsTakenAndVerticesWithoutFacetAreLeftOut) {
  const Surface<3> small = test::unit_sphere(4);
  const Surface<3> large =
      test::mapped<3>(test::unit_sphere(4), [](const Vec<3>& x) { return Vec<3>(2 * x + Vec<3>(9, 0, 0)); });
  Surface<3> both = test::joined(small, large);
  both.vertices.push_back({5, 5, 5});
  const PreparedSurface prepared = prepare_surface(both, {});
  EXPECT_EQ(prepared.surface.vertices, large.vertices);
  EXPECT_NEAR(prepared.share, 0.8, 1e-12);
  EXPECT_EQ(n_large_components(both), 2u);
  EXPECT_EQ(prepare_surface(both, {}, 1).surface.vertices, small.vertices);
  const auto n = small.vertices.size();
  EXPECT_EQ(prepared.nearest[0], no_index);
  EXPECT_EQ(prepared.nearest[n + 3], 3);
  EXPECT_EQ(prepared.nearest.back(), no_index);
}

TEST(AlikeComponents, AFloorOfEitherSurfaceIsLeftOut) {
  const Surface<3> ring = test::torus(2, 0.4, 60, 20), floor = test::box({-6, -6, -1}, {6, 6, -0.9});
  const Surface<3> other_ring =
      test::mapped<3>(test::torus(2, 0.42, 60, 20), [](const Vec<3>& x) { return Vec<3>(70 * x); });
  using Ranks = std::array<std::size_t, 2>;
  EXPECT_EQ(alike_components(test::joined(floor, ring), other_ring, {}), Ranks({1, 0}));
  EXPECT_EQ(alike_components(other_ring, test::joined(ring, floor), {}), Ranks({0, 1}));
  // Where the largest are about as much alike they stay.
  EXPECT_EQ(alike_components(test::joined(ring, floor), test::joined(floor, ring), {}), Ranks({0, 0}));
}

TEST(PreparedSurface, ASurfaceWithoutAreaIsRefused) {
  EXPECT_THROW(prepare_surface({}, {}), InputError);
  EXPECT_THROW(prepare_surface({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}, {}), InputError);
}

}  // namespace
}  // namespace shellmatch
