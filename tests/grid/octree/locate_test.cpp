#include "grid/octree/cell_locator.h"
#include "grid/fields/interpolation.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using test::random_grid;
using test::random_point;

// The leaf that contains x when each cell owns its lower faces and the domain's upper faces close it.
template <int Dim>
Index locate_by_search(const Octree<Dim>& grid, const Vec<Dim>& x) {
  for (const Index leaf : grid.leaves()) {
    const Vec<Dim> low = grid.cell_corner(leaf);
    const double side = grid.cell(leaf).side();
    bool inside = true;
    for (int k = 0; k < Dim; ++k)
      inside = inside && x[k] >= low[k] && (x[k] < low[k] + side || (x[k] == 1 && low[k] + side == 1));
    if (inside) return leaf;
  }
  return no_index;
}

template <int Dim>
void expect_found(const Octree<Dim>& grid, const Vec<Dim>& x) {
  const Vec<Dim> projected = x.cwiseMax(0.0).cwiseMin(1.0);
  ASSERT_EQ(grid.locate(x), locate_by_search(grid, projected)) << x.transpose();
  const auto local = locate_local(grid, x);
  ASSERT_EQ(local.cell, grid.locate(x));
  ASSERT_TRUE((local.xi.array() >= 0).all() && (local.xi.array() <= 1).all()) << local.xi.transpose();
  const Vec<Dim> back = grid.cell_corner(local.cell) + grid.cell(local.cell).side() * local.xi;
  ASSERT_LE((back - projected).norm(), 1e-15);
}

template <int Dim>
void check_against_search(const Octree<Dim>& grid) {
  std::mt19937 random(11);
  for (int i = 0; i < 2000; ++i) expect_found<Dim>(grid, random_point<Dim>(random));
  for (int i = 0; i < 500; ++i) expect_found<Dim>(grid, random_point<Dim>(random, -0.5, 1.5));
  for (Index n = 0; n < grid.n_nodes(); n += 3) expect_found<Dim>(grid, grid.node_position(n));
  for (const Index leaf : grid.leaves())  // on faces
    for (int k = 0; k < Dim; ++k) {
      Vec<Dim> x = grid.cell_centre(leaf);
      x[k] += 0.5 * grid.cell(leaf).side();
      expect_found<Dim>(grid, x);
      x[k] = std::nextafter(x[k], 0.0);
      expect_found<Dim>(grid, x);
    }
}

TEST(Locate, AgreesWithSearchInThePlane) {
  check_against_search(Octree<2>(0));
  check_against_search(random_grid<2>(2, 4, 0.3, 7));
}

TEST(Locate, AgreesWithSearchInSpace) {
  check_against_search(Octree<3>(2));
  check_against_search(random_grid<3>(1, 3, 0.3, 8));
}

// Finer than the look-up table, so that the descent below it is walked.
TEST(Locate, AgreesWithSearchBelowTheTable) {
  Octree<3> grid(1);
  const Vec<3> target(0.37, 0.61, 0.23);
  for (int s = 0; s < 9; ++s) {
    const Index leaf = grid.locate(target);
    grid.refine([&](Index c) { return c == leaf; });
  }
  EXPECT_EQ(grid.finest_level(), 10);
  expect_found<3>(grid, target);
  std::mt19937 random(12);
  for (int i = 0; i < 2000; ++i) expect_found<3>(grid, random_point<3>(random));
  for (int i = 0; i < 2000; ++i) expect_found<3>(grid, target + 0.01 * random_point<3>(random, -1, 1));
}

// Eight at once like one by one: whatever the levels and the places, below the look-up table too.
template <int Dim>
void check_eight_at_once() {
  CellLocator<Dim> locator;
  std::mt19937 random(21);
  std::uniform_int_distribution<int> one_of(0, 2);
  std::vector<Index> leaves{0};
  const int finest = Dim == 2 ? 11 : 8;
  for (int level = 1; level <= finest; ++level) {
    const Index n = locator.n_cells();
    locator.split(leaves, level);
    leaves.clear();
    for (Index c = n; c < locator.n_cells(); ++c)
      if (c == n || (one_of(random) == 0 && leaves.size() < 200)) leaves.push_back(c);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (int trial = 0; trial < 500; ++trial) {
    std::array<std::array<double, 8>, Dim> x;
    for (int lane = 0; lane < 8; ++lane) {
      const double spread = lane < 4 ? 1.3 : 0.01;
      const Vec<Dim> at = random_point<Dim>(random, -0.2, 1) * spread;
      for (int k = 0; k < Dim; ++k) x[k][lane] = at[k];
    }
    x[0][1] = trial % 2 ? 1.0 : inf;
    x[1][2] = trial % 2 ? nan : -inf;
    std::array<Index, 8> leaf;
    locator.locate(x, leaf);
    for (int lane = 0; lane < 8; ++lane) {
      Vec<Dim> at;
      for (int k = 0; k < Dim; ++k) at[k] = x[k][lane];
      ASSERT_EQ(leaf[lane], locator.locate(at)) << at.transpose();
      ASSERT_EQ(locator.first_child(leaf[lane]), no_index);
    }
  }
}

TEST(Locate, FindsEightAtOnce) {
  check_eight_at_once<2>();
  check_eight_at_once<3>();
}

TEST(Locate, SurvivesWhatIsNoNumber) {
  const Octree<3> grid(3);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(grid.locate({nan, 0.0, 0.0}), grid.locate({0.0, 0.0, 0.0}));
  EXPECT_EQ(grid.locate({inf, -inf, 1e300}), grid.locate({1.0, 0.0, 1.0}));
}

}  // namespace
}  // namespace shellmatch
