#include "grid/fields/fast_marching.h"

#include "base/parallel.h"
#include "grid/octree/constraints.h"
#include "grid/fields/sample.h"
#include "tests/grid/exact_shapes.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <atomic>

namespace shellmatch {
namespace {

using test::ExactShape;
using test::sphere;
using test::torus;

struct Errors {
  double inside = 0, outside = 0;  // means
};

// Over the free nodes at these distances from the surface.
template <int Dim>
Errors errors(const Octree<Dim>& grid, const ExactShape<Dim>& shape, double near, double far) {
  const auto d = march_distance<Dim>(grid, shape.distance);
  Errors e;
  double n_inside = 0, n_outside = 0;
  for (const Index node : grid.free_nodes()) {
    const double exact = shape.distance(grid.node_position(node));
    if (std::abs(exact) < near || std::abs(exact) > far) continue;
    (exact < 0 ? e.inside : e.outside) += std::abs(d[node] - exact);
    (exact < 0 ? n_inside : n_outside) += 1;
  }
  return {e.inside / n_inside, e.outside / n_outside};
}

// Observed order from one level to the next, on both sides of the surface. It rises to 1 from below, as the layer
// of exact values, which becomes thinner, covers a part of the way.
template <int Dim>
void expect_first_order(const ExactShape<Dim>& shape, int from, int to, double near, double far, double least) {
  Errors coarse = errors(Octree<Dim>(from), shape, near, far);
  for (int level = from + 1; level <= to; ++level) {
    const Errors fine = errors(Octree<Dim>(level), shape, near, far);
    for (const auto& [before, after] : {std::pair(coarse.inside, fine.inside), {coarse.outside, fine.outside}}) {
      EXPECT_GT(std::log2(before / after), least) << "level " << level;
      EXPECT_LT(std::log2(before / after), 1.1) << "level " << level;
    }
    coarse = fine;
  }
}

TEST(FastMarching, FirstOrderOnUniformGrids) {
  expect_first_order(sphere<2>(0.3), 7, 9, 0.1, 0.2, 0.85);
  expect_first_order(sphere<3>(0.3), 5, 6, 0.1, 0.2, 0.5);
  expect_first_order(torus(0.27, 0.14), 5, 6, 0.08, 0.12, 0.4);
}

// Two cells to either side of the surface, which is what the energies see, values are exact or one step away from
// exact ones: errors stay below a share of the square of the side times the curvature.
template <int Dim>
void expect_second_order_in_band(const ExactShape<Dim>& shape, int from, int to, double largest_curvature) {
  for (int level = from; level <= to; ++level) {
    const auto grid = test::shape_grid<Dim>(3, level, shape.distance);
    const auto d = march_distance<Dim>(grid, shape.distance);
    const double h = grid.finest_side();
    double worst = 0;
    for (const Index node : grid.free_nodes()) {
      const double exact = shape.distance(grid.node_position(node));
      if (std::abs(exact) < 2 * h) worst = std::max(worst, std::abs(d[node] - exact));
    }
    EXPECT_LT(worst, 0.5 * largest_curvature * h * h);
  }
}

TEST(FastMarching, SecondOrderInTheBand) {
  expect_second_order_in_band(sphere<2>(0.3), 5, 10, 1 / 0.3);
  expect_second_order_in_band(sphere<3>(0.3), 4, 7, 2 / 0.3);
  expect_second_order_in_band(torus(0.27, 0.14), 5, 7, 1 / 0.14 + 1 / 0.13);
}

// The coarse leaves far from the surface become no smaller when the finest do: their error stays of the order of
// their own side, and so of the distance.
TEST(FastMarching, ErrorIsBoundedByTheLeafOnGradedGrids) {
  const auto shape = torus(0.27, 0.14);
  const auto grid = test::shape_grid<3>(3, 6, shape.distance);
  const auto d = march_distance<3>(grid, shape.distance);
  for (const Index leaf : grid.leaves())
    for (const Index node : grid.cell(leaf).nodes) {
      if (grid.free_index(node) == no_index) continue;
      ASSERT_LE(std::abs(d[node] - shape.distance(grid.node_position(node))), 0.75 * grid.cell(leaf).side());
    }
}

template <int Dim>
void expect_exact_on_planes() {
  for (int axis = 0; axis < Dim; ++axis)
    for (unsigned seed = 0; seed < 3; ++seed) {
      const auto grid = test::random_grid<Dim>(2, 3, 0.3, seed);
      const auto plane = [&](const Vec<Dim>& x) { return (axis == 1 ? -1 : 1) * (x[axis] - 0.37); };
      const auto d = march_distance<Dim>(grid, plane);
      for (Index n = 0; n < grid.n_nodes(); ++n) ASSERT_NEAR(d[n], plane(grid.node_position(n)), 1e-11);
    }
}

TEST(FastMarching, ExactOnPlanesAcrossLevels) {
  expect_exact_on_planes<2>();
  expect_exact_on_planes<3>();
}

// A plane in general position is exact too wherever the front does not come along the domain's boundary.
TEST(FastMarching, ExactOnObliquePlanesAwayFromTheBoundary) {
  const Vec<2> n = Vec<2>(0.6, 0.8);
  const auto plane = [&](const Vec<2>& x) { return n.dot(x - Vec<2>(0.5, 0.5)); };
  for (unsigned seed = 0; seed < 5; ++seed) {
    const auto grid = test::random_grid<2>(3, 3, 0.3, seed);
    const auto d = march_distance<2>(grid, plane);
    int n_seen = 0;
    for (const Index node : grid.free_nodes()) {
      const Vec<2> x = grid.node_position(node);
      if (std::abs(x[0] - 0.5) > 0.15 || std::abs(x[1] - 0.5) > 0.15) continue;
      ASSERT_NEAR(d[node], plane(x), 1e-11);
      ++n_seen;
    }
    EXPECT_GT(n_seen, 20);
  }
}

template <int Dim>
void expect_signs_and_slope(const Octree<Dim>& grid, const std::function<double(const Vec<Dim>&)>& distance) {
  const auto d = march_distance<Dim>(grid, distance);
  for (const Index node : grid.free_nodes()) {
    const double exact = distance(grid.node_position(node));
    ASSERT_TRUE(std::abs(exact) < 1e-12 || (exact < 0) == (d[node] < 0));
  }
  // No steeper than a distance may be: a value is at most that of a neighbour and the way to it.
  for (const Index leaf : grid.leaves()) {
    const auto& cell = grid.cell(leaf);
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int k = 0; k < Dim; ++k) {
        const Index a = cell.nodes[c], b = cell.nodes[c ^ (1 << k)];
        if (grid.free_index(a) == no_index || grid.free_index(b) == no_index) continue;
        ASSERT_LE(std::abs(d[a] - d[b]), cell.side() * (1 + 1e-9));
      }
  }
}

// Balls with a gap between them, one inside a shell, and what refinement does where another shape lies.
TEST(FastMarching, SignsAgreeAndSlopesAreThoseOfADistance) {
  const auto balls = [](const Vec<3>& x) {
    return std::min((x - Vec<3>(0.3, 0.4, 0.5)).norm() - 0.18, (x - Vec<3>(0.7, 0.6, 0.5)).norm() - 0.2);
  };
  expect_signs_and_slope<3>(test::shape_grid<3>(3, 6, balls), balls);
  const auto shell = [](const Vec<3>& x) { return std::abs((x - Vec<3>::Constant(0.5)).norm() - 0.25) - 0.03; };
  expect_signs_and_slope<3>(Octree<3>(4), shell);
  // Refined elsewhere: the front goes from coarse to fine leaves.
  const auto other = torus(0.3, 0.1);
  expect_signs_and_slope<3>(test::shape_grid<3>(3, 6, other.distance), sphere<3>(0.12).distance);
  for (unsigned seed = 0; seed < 10; ++seed)
    expect_signs_and_slope<2>(test::random_grid<2>(3, 4, 0.35, seed), sphere<2>(0.23).distance);
}

TEST(FastMarching, HangingNodesAreInterpolated) {
  const auto grid = test::random_grid<3>(2, 3, 0.3, 4);
  const auto d = march_distance<3>(grid, sphere<3>(0.3).distance);
  auto conforming = d;
  distribute(grid, conforming);
  EXPECT_EQ(d, conforming);
}

TEST(FastMarching, AsksForFewDistances) {
  const Octree<3> grid(5);
  std::atomic<int> n_calls = 0;
  march_distance<3>(grid, [&](const Vec<3>& x) {
    ++n_calls;
    return sphere<3>(0.3).distance(x);
  });
  EXPECT_LT(n_calls, grid.n_nodes() / 2);
}

TEST(FastMarching, RefinementImprovesTheValues) {
  const auto shape = sphere<2>(0.3);
  auto grid = test::shape_grid<2>(3, 5, shape.distance);
  const Errors coarse = errors(grid, shape, 0, 1);
  grid.refine([](Index) { return true; });
  const Errors fine = errors(grid, shape, 0, 1);
  EXPECT_LT(fine.inside, coarse.inside);
  EXPECT_LT(fine.outside, coarse.outside);
}

TEST(FastMarching, SameBitsWithOneAndTwoThreads) {
  const auto shape = torus(0.25, 0.12);
  const auto grid = test::shape_grid<3>(3, 5, shape.distance);
  set_n_threads(1);
  const auto one = march_distance<3>(grid, shape.distance);
  set_n_threads(2);
  EXPECT_EQ(one, march_distance<3>(grid, shape.distance));
}

TEST(FastMarching, ASurfaceOutsideOfTheGridIsAnError) {
  EXPECT_THROW(march_distance<2>(Octree<2>(3), [](const Vec<2>& x) { return x[0] + 5; }), std::logic_error);
}

}  // namespace
}  // namespace shellmatch
