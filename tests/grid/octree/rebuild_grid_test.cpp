// A tree from the list of its leaves, whatever their order, and lists that are no tree's.
#include "grid/octree/rebuild_grid.h"

#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace shellmatch {
namespace {

template <int Dim>
void expect_the_same_tree(unsigned seed) {
  const Octree<Dim> grid = test::random_grid<Dim>(1, 4, 0.3, seed);
  std::vector<LeafPlace<Dim>> leaves;
  for (const Index leaf : grid.leaves()) leaves.push_back({grid.cell(leaf).level, grid.cell(leaf).corner});
  std::mt19937 random(seed);
  std::shuffle(leaves.begin(), leaves.end(), random);
  const std::optional<Octree<Dim>> again = rebuild_grid<Dim>(leaves);
  ASSERT_TRUE(again);
  ASSERT_EQ(again->leaves().size(), leaves.size());
  EXPECT_EQ(again->n_nodes(), grid.n_nodes());
  EXPECT_EQ(again->hanging_nodes().size(), grid.hanging_nodes().size());
  for (const LeafPlace<Dim>& leaf : leaves) {
    const Index c = again->find_cell(leaf.level, leaf.corner);
    ASSERT_NE(c, no_index);
    EXPECT_TRUE(again->cell(c).is_leaf());
  }
}
TEST(RebuildGrid, GivesTheTreeOfItsLeaves) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    expect_the_same_tree<2>(seed);
    expect_the_same_tree<3>(seed);
  }
}

TEST(RebuildGrid, RefusesGapsOverlapsAndLostBalance) {
  const std::vector<LeafPlace<2>> good{{1, {0, 0}}, {1, {1, 0}}, {1, {0, 1}}, {1, {1, 1}}};
  EXPECT_TRUE(rebuild_grid<2>(good));
  auto gap = good;
  gap.pop_back();
  EXPECT_FALSE(rebuild_grid<2>(gap));
  auto twice = good;
  twice[3] = twice[0];  // fills the volume all the same
  EXPECT_FALSE(rebuild_grid<2>(twice));
  auto more = good;
  more.push_back({2, {0, 0}});
  EXPECT_FALSE(rebuild_grid<2>(more));

  // A cell of level 3 beside one of level 1.
  std::vector<LeafPlace<2>> steep{{1, {0, 0}}, {1, {0, 1}}, {1, {1, 1}}, {2, {3, 0}}, {2, {2, 1}}, {2, {3, 1}}};
  for (int c = 0; c < 4; ++c) steep.push_back({3, {4 + (c & 1), c >> 1}});
  EXPECT_FALSE(rebuild_grid<2>(steep));

  // What would need a fine uniform grid costs nothing.
  EXPECT_FALSE(rebuild_grid<3>({{19, {0, 0, 0}}, {19, {5, 5, 5}}}));
}

}  // namespace
}  // namespace shellmatch
