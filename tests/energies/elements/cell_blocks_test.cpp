#include "energies/elements/cell_blocks.h"

#include <gtest/gtest.h>

#include <mutex>
#include <vector>

#include "tests/energies/matching_problem.h"

namespace shellmatch::test {
namespace {

// Local indices and entries stand for the constraint entries of the grid, each entry of each element corner once.
template <int Dim>
void check_local_numbering(BoundaryCondition boundary) {
  const Octree<Dim> grid = hanging_grid<Dim>(boundary == BoundaryCondition::dirichlet ? 0.45 : 0.3);
  const Unknowns<Dim> unknowns(grid, boundary);
  const CellBlocks<Dim> cell_blocks(unknowns);
  ASSERT_GT(cell_blocks.size(), 1u) << "too few to tell";
  const std::size_t n = unknowns.nodes().size();
  std::vector<std::size_t> n_entries(n, 0), n_expected(n, 0), n_first(n, 0), n_blocks(n, 0);
  std::size_t n_cells = 0;
  std::mutex mutex;
  cell_blocks.for_each([&](const Chunk& cells) {
    const std::lock_guard lock(mutex);
    n_cells += cells.end - cells.begin;
    EXPECT_LE(cells.end - cells.begin, cells_per_block(unknowns.elements().size()));
    const auto local_unknowns = cell_blocks.local_unknowns(cells.index);
    for (std::size_t i = 0; i < local_unknowns.size(); ++i) {
      const Index unknown = local_unknowns[i].unknown;
      EXPECT_EQ(local_unknowns[i].is_first, n_blocks[unknown] == 0);
      EXPECT_TRUE(i == 0 || local_unknowns[i - 1].unknown < unknown);
      n_first[unknown] += local_unknowns[i].is_first;
      ++n_blocks[unknown];
    }
    std::vector<char> is_used(local_unknowns.size(), 0);
    const auto count = [&](std::size_t i) {
      ++n_entries[local_unknowns[i].unknown];
      is_used[i] = 1;
    };
    for (std::size_t e = cells.begin; e < cells.end; ++e)
      for (int c = 0; c < n_corners<Dim>; ++c) {
        const std::size_t i = cell_blocks.local_indices(e)[c];
        const Index node = unknowns.elements()[e].nodes[c];
        if (i < local_unknowns.size()) {
          EXPECT_EQ(unknowns.nodes()[local_unknowns[i].unknown], node);
          count(i);
          continue;
        }
        const auto local = cell_blocks.local_entries(cells.index, i - local_unknowns.size());
        const auto expected = unknowns.constraint_entries(node);
        ASSERT_EQ(local.size(), expected.size());
        for (std::size_t j = 0; j < local.size(); ++j) {
          EXPECT_EQ(local_unknowns[local[j].local_index].unknown, expected[j].unknown);
          EXPECT_EQ(local[j].weight, expected[j].weight);
          count(local[j].local_index);
        }
      }
    for (const char used : is_used) EXPECT_TRUE(used);
  });
  EXPECT_EQ(n_cells, unknowns.elements().size());
  for (const Element<Dim>& element : unknowns.elements())
    for (const Index node : element.nodes)
      for (const ConstraintEntry& entry : unknowns.constraint_entries(node)) ++n_expected[entry.unknown];
  EXPECT_EQ(n_entries, n_expected);
  EXPECT_EQ(n_first, std::vector<std::size_t>(n, 1));
}

TEST(CellBlocks, NumberTheUnknownsOfTheirElements) {
  for (const auto boundary : {BoundaryCondition::neumann, BoundaryCondition::dirichlet}) {
    check_local_numbering<2>(boundary);
    check_local_numbering<3>(boundary);
  }
}

}  // namespace
}  // namespace shellmatch::test
