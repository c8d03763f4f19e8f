#include "grid/octree/octree.h"
#include "base/parallel.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace shellmatch {
namespace {

using test::random_grid;

template <class D>
class OctreeTest : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(OctreeTest, Dims);

template <int Dim>
std::vector<Octree<Dim>> grids() {
  std::vector<Octree<Dim>> all;
  all.emplace_back(0);
  all.emplace_back(3);
  all.push_back(random_grid<Dim>(1, 4, 0.3, 1));
  all.push_back(random_grid<Dim>(2, 3, 0.1, 2));
  // Leaf [3/4, 7/8] asks for [1/2, 3/4] to be split, and that for [0, 1/2]: balance has to ripple.
  Octree<Dim> deep(1);
  const Vec<Dim> corner = Vec<Dim>::Constant(0.76);
  for (int s = 0; s < 6; ++s) {
    const Index target = deep.locate(corner);
    deep.refine([&](Index leaf) { return leaf == target; });
  }
  all.push_back(deep);
  return all;
}

TYPED_TEST(OctreeTest, UniformGridCountsItsParts) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(4);
  EXPECT_EQ(grid.n_nodes(), Dim == 2 ? 17 * 17 : 17 * 17 * 17);
  EXPECT_EQ(grid.leaves().size(), Dim == 2 ? 256u : 4096u);
  EXPECT_TRUE(grid.hanging_nodes().empty());
  EXPECT_EQ(grid.free_nodes().size(), static_cast<std::size_t>(grid.n_nodes()));
  EXPECT_EQ(grid.finest_level(), 4);
  EXPECT_EQ(grid.finest_side(), 1.0 / 16);
}

TYPED_TEST(OctreeTest, LeavesTileTheDomain) {
  constexpr int Dim = TypeParam::value;
  for (const auto& grid : grids<Dim>()) {
    double volume = 0;
    for (const Index leaf : grid.leaves()) volume += std::pow(grid.cell(leaf).side(), Dim);
    EXPECT_EQ(volume, 1.0);
    EXPECT_TRUE(std::is_sorted(grid.leaves().begin(), grid.leaves().end()));
  }
}

TYPED_TEST(OctreeTest, NodesOfCellsAreTheirCorners) {
  constexpr int Dim = TypeParam::value;
  for (const auto& grid : grids<Dim>())
    for (Index c = 0; c < grid.n_cells(); ++c) {
      const auto& cell = grid.cell(c);
      EXPECT_EQ(grid.find_cell(cell.level, cell.corner), c);
      for (int corner = 0; corner < n_corners<Dim>; ++corner) {
        Vec<Dim> expected = grid.cell_corner(c);
        for (int k = 0; k < Dim; ++k) expected[k] += ((corner >> k) & 1) * cell.side();
        ASSERT_EQ(grid.node_position(cell.nodes[corner]), expected);
        ASSERT_EQ(grid.find_node(grid.node_coord(cell.nodes[corner])), cell.nodes[corner]);
      }
    }
}

TYPED_TEST(OctreeTest, FindsWhatIsThereAndNothingElse) {
  constexpr int Dim = TypeParam::value;
  using Coord = typename Octree<Dim>::Coord;
  for (const auto& grid : grids<Dim>()) {
    std::map<std::pair<int, Coord>, Index> cells;
    std::map<Coord, Index> nodes;
    for (Index c = 0; c < grid.n_cells(); ++c) cells[{grid.cell(c).level, grid.cell(c).corner}] = c;
    for (Index n = 0; n < grid.n_nodes(); ++n) nodes[grid.node_coord(n)] = n;
    const auto expect_cell = [&](int level, const Coord& corner, Index found) {
      const auto there = cells.find({level, corner});
      ASSERT_EQ(found, there == cells.end() ? no_index : there->second) << "level " << level;
    };
    const auto probe = [&](int level, const Coord& corner) {
      expect_cell(level, corner, grid.find_cell(level, corner));
      for (const std::int32_t v : corner)
        if (level < 0 || v < 0 || v >= 1 << level) return;
      const auto around = grid.find_neighbours(level, corner);
      for (int n = 0; n < n_lattice<Dim>; ++n) {
        Coord neighbour = corner;
        for (int k = 0; k < Dim; ++k) neighbour[k] += lattice_point<Dim>(n)[k] - 1;
        expect_cell(level, neighbour, around[n]);
      }
    };
    for (const auto& [place, number] : cells) {
      probe(place.first, place.second);
      auto child = place.second;
      for (std::int32_t& v : child) v *= 2;
      probe(place.first + 1, child);
    }
    std::mt19937 random(7);
    for (int i = 0; i < 5000; ++i) {
      const int level = std::uniform_int_distribution(-1, grid.finest_level() + 1)(random);
      const int unit = Octree<Dim>::max_level - std::max(level, 0);
      std::uniform_int_distribution<std::int32_t> place(0, 1 << std::max(level, 0));
      Coord position, corner;
      for (int k = 0; k < Dim; ++k) {
        position[k] = place(random) << unit;
        corner[k] = place(random) - (i % 2);
      }
      probe(level, corner);
      const auto there = nodes.find(position);
      ASSERT_EQ(grid.find_node(position), there == nodes.end() ? no_index : there->second);
    }
  }
}

// Two leaves touch if their closures meet, be it in one point.
TYPED_TEST(OctreeTest, TouchingLeavesDifferByOneLevelAtMost) {
  constexpr int Dim = TypeParam::value;
  for (const auto& grid : grids<Dim>())
    for (const Index a : grid.leaves())
      for (const Index b : grid.leaves()) {
        if (grid.cell(a).level <= grid.cell(b).level + 1) continue;
        const double reach = 0.5 * (grid.cell(a).side() + grid.cell(b).side());
        const double gap = (grid.cell_centre(a) - grid.cell_centre(b)).cwiseAbs().maxCoeff();
        ASSERT_GT(gap, reach) << "leaves " << a << " and " << b;
      }
}

TYPED_TEST(OctreeTest, HangingNodesAreThoseOnALeafWithoutBeingItsCorner) {
  constexpr int Dim = TypeParam::value;
  for (const auto& grid : grids<Dim>()) {
    std::set<Index> expected;
    for (const Index leaf : grid.leaves())
      for (Index n = 0; n < grid.n_nodes(); ++n) {
        const auto& nodes = grid.cell(leaf).nodes;
        const double half = 0.5 * grid.cell(leaf).side();
        const bool touches = (grid.node_position(n) - grid.cell_centre(leaf)).cwiseAbs().maxCoeff() <= half;
        if (touches && std::find(nodes.begin(), nodes.end(), n) == nodes.end()) expected.insert(n);
      }
    std::set<Index> found;
    for (const auto& h : grid.hanging_nodes()) found.insert(h.node);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(found.size(), grid.hanging_nodes().size());
    EXPECT_TRUE(std::ranges::is_sorted(grid.hanging_nodes(), {}, &HangingNode<Dim>::node));
    EXPECT_EQ(grid.free_nodes().size() + found.size(), static_cast<std::size_t>(grid.n_nodes()));
    for (std::size_t i = 0; i < grid.free_nodes().size(); ++i)
      EXPECT_EQ(grid.free_index(grid.free_nodes()[i]), static_cast<Index>(i));
  }
}

TYPED_TEST(OctreeTest, ParentsAreFreeAndSurroundTheirNode) {
  constexpr int Dim = TypeParam::value;
  for (const auto& grid : grids<Dim>())
    for (const auto& h : grid.hanging_nodes()) {
      EXPECT_EQ(grid.free_index(h.node), no_index);
      ASSERT_TRUE(h.n_parents == 2 || (Dim == 3 && h.n_parents == 4));
      Vec<Dim> mean = Vec<Dim>::Zero();
      for (int p = 0; p < h.n_parents; ++p) {
        EXPECT_NE(grid.free_index(h.parents[p]), no_index);
        mean += grid.node_position(h.parents[p]) / h.n_parents;
      }
      EXPECT_EQ(mean, grid.node_position(h.node));
    }
}

TYPED_TEST(OctreeTest, NumbersKeepTheirMeaning) {
  constexpr int Dim = TypeParam::value;
  auto grid = random_grid<Dim>(2, 2, 0.3, 3);
  const auto before = grid;
  const Index first = grid.leaves()[grid.leaves().size() / 2];
  const std::size_t n_split = grid.refine([&](Index leaf) { return leaf == first || leaf % 7 == 0; });
  EXPECT_GT(n_split, 0u);
  EXPECT_EQ(static_cast<std::size_t>(grid.n_cells() - before.n_cells()), n_split * n_corners<Dim>);
  EXPECT_FALSE(grid.cell(first).is_leaf());
  for (Index n = 0; n < before.n_nodes(); ++n) ASSERT_EQ(grid.node_position(n), before.node_position(n));
  for (Index c = 0; c < before.n_cells(); ++c) {
    ASSERT_EQ(grid.cell(c).corner, before.cell(c).corner);
    ASSERT_EQ(grid.cell(c).level, before.cell(c).level);
    ASSERT_EQ(grid.cell(c).nodes, before.cell(c).nodes);
  }
}

TYPED_TEST(OctreeTest, SplitsWhatIsMarkedAndNothingElseWithoutNeed) {
  constexpr int Dim = TypeParam::value;
  Octree<Dim> grid(3);
  EXPECT_EQ(grid.refine([](Index) { return false; }), 0u);
  const Index leaf = grid.locate(Vec<Dim>::Constant(0.3));
  EXPECT_EQ(grid.refine([&](Index c) { return c == leaf; }), 1u);
  EXPECT_EQ(grid.finest_level(), 4);
}

TYPED_TEST(OctreeTest, SameNumbersWithOneAndTwoThreads) {
  constexpr int Dim = TypeParam::value;
  const auto make = [](int n_threads) {
    set_n_threads(n_threads);
    return random_grid<Dim>(Dim == 2 ? 6 : 4, 2, 0.2, 5);
  };
  const auto one = make(1), two = make(2);
  ASSERT_EQ(one.n_nodes(), two.n_nodes());
  ASSERT_EQ(one.n_cells(), two.n_cells());
  for (Index n = 0; n < one.n_nodes(); ++n) ASSERT_EQ(one.node_coord(n), two.node_coord(n));
  for (Index c = 0; c < one.n_cells(); ++c) {
    ASSERT_EQ(one.cell(c).corner, two.cell(c).corner);
    ASSERT_EQ(one.cell(c).first_child, two.cell(c).first_child);
    ASSERT_EQ(one.cell(c).nodes, two.cell(c).nodes);
  }
  ASSERT_EQ(one.hanging_nodes().size(), two.hanging_nodes().size());
  for (std::size_t h = 0; h < one.hanging_nodes().size(); ++h) {
    ASSERT_EQ(one.hanging_nodes()[h].node, two.hanging_nodes()[h].node);
    ASSERT_EQ(one.hanging_nodes()[h].parents, two.hanging_nodes()[h].parents);
  }
}

TEST(Octree, RefusesToGoBelowTheFinestLevel) {
  Octree<2> grid(1);
  const auto descend = [&] {
    const Index target = grid.locate(Vec<2>(0, 0));
    grid.refine([&](Index leaf) { return leaf == target; });
  };
  while (grid.finest_level() < Octree<2>::max_level) descend();
  EXPECT_EQ(grid.cell(grid.locate(Vec<2>(0, 0))).level, Octree<2>::max_level);
  EXPECT_EQ(grid.cell(grid.locate(Vec<2>(0.99, 0.99))).level, 1);
  EXPECT_THROW(descend(), std::logic_error);
  EXPECT_THROW(Octree<2>(-1), std::logic_error);
}

}  // namespace
}  // namespace shellmatch
