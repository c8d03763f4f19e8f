// The outline of a grid describes it completely, or at a coarser level where that is asked for.

#include "matching/report/grid_outline.h"

#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace shellmatch {
namespace {

template <int Dim>
double volume(const GridOutline<Dim>& outline) {
  double sum = 0;
  for (const auto level : outline.levels) sum += std::pow(0.5, Dim * level);
  return sum;
}

template <int Dim>
void expect_complete() {
  const Octree<Dim> grid = test::random_grid<Dim>(2, 3, 0.3, 5);
  const GridOutline<Dim> outline = grid_outline(grid, 1000000);
  EXPECT_EQ(outline.finest_level, grid.finest_level());
  EXPECT_EQ(outline.levels.size(), grid.leaves().size());
  EXPECT_EQ(volume(outline), 1);
  // All nodes are corners of leaves; they come by their last coordinate first.
  EXPECT_EQ(outline.corners.size(), static_cast<std::size_t>(grid.n_nodes()));
  EXPECT_EQ(std::set<Index>(outline.corners.begin(), outline.corners.end()).size(), outline.corners.size());
  for (std::size_t i = 1; i < outline.corners.size(); ++i) {
    auto a = grid.node_coord(outline.corners[i - 1]), b = grid.node_coord(outline.corners[i]);
    std::ranges::reverse(a);
    std::ranges::reverse(b);
    EXPECT_LT(a, b);
  }
}

TEST(GridOutline, HasAllCellsAndNodes) {
  expect_complete<2>();
  expect_complete<3>();
}

TEST(GridOutline, IsCoarserWhereThereWouldBeTooManyCorners) {
  const Octree<3> grid = test::random_grid<3>(2, 3, 0.3, 5);
  const GridOutline<3> outline = grid_outline(grid, 400);
  EXPECT_LT(outline.finest_level, grid.finest_level());
  EXPECT_LE(outline.corners.size(), 400u);
  EXPECT_GE(outline.corners.size(), 125u);
  EXPECT_EQ(volume(outline), 1);
  for (const auto level : outline.levels) EXPECT_LE(level, outline.finest_level);
  EXPECT_EQ(grid_outline(grid, 0).levels, std::vector<std::uint8_t>{0});
}

// Depth first, and child c on the upper side along axis k if bit k of c is set.
TEST(GridOutline, CellsStandAlongTheMortonCurve) {
  Octree<2> grid(1);
  grid.refine([&](Index leaf) { return (grid.cell_centre(leaf) - Vec<2>(0.75, 0.25)).norm() < 0.01; });
  EXPECT_EQ(grid_outline(grid, 1000).levels, (std::vector<std::uint8_t>{1, 2, 2, 2, 2, 1, 1}));
}

}  // namespace
}  // namespace shellmatch
