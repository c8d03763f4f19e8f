// The order of fast marching over levels 4 to 7 in space, which takes too long for every run of the tests.

#include "grid/fields/fast_marching.h"
#include "tests/grid/exact_shapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace shellmatch {
namespace {

// Mean errors inside and outside at these distances from the surface, on uniform grids.
void expect_slopes(const test::ExactShape<3>& shape, double near, double far) {
  std::vector<std::array<double, 2>> logs;
  for (int level = 4; level <= 7; ++level) {
    const Octree<3> grid(level);
    const auto d = march_distance<3>(grid, shape.distance);
    std::array<double, 2> sum{}, n{};
    for (const Index node : grid.free_nodes()) {
      const double exact = shape.distance(grid.node_position(node));
      if (std::abs(exact) < near || std::abs(exact) > far) continue;
      sum[exact < 0] += std::abs(d[node] - exact);
      n[exact < 0] += 1;
    }
    logs.push_back({std::log2(sum[0] / n[0]), std::log2(sum[1] / n[1])});
  }
  for (const int side : {0, 1}) {
    const char* name = side == 1 ? "inside" : "outside";
    // The order rises to 1 from below, as the layer of exact values that the front starts from becomes thinner.
    const double before = logs[1][side] - logs[2][side], last = logs[2][side] - logs[3][side];
    EXPECT_GT(last, before) << name;
    EXPECT_GT(last, 0.75) << name;
    EXPECT_LT(last, 1.05) << name;
  }
}

TEST(FastMarchingOrder, Sphere) { expect_slopes(test::sphere<3>(0.3), 0.1, 0.2); }
TEST(FastMarchingOrder, Torus) { expect_slopes(test::torus(0.27, 0.14), 0.08, 0.12); }

}  // namespace
}  // namespace shellmatch
