// CellBlocks of elements and the waves in which they are worked off.

#include "energies/elements/cell_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "tests/energies/matching_problem.h"

namespace shellmatch::test {
namespace {

/// Piece i touches i, 2 i and 3 i modulo 50.
std::vector<Index> touched(std::size_t i) {
  std::vector<Index> numbers;
  for (const std::size_t factor : {1, 2, 3}) numbers.push_back(static_cast<Index>(factor * i % 50));
  return numbers;
}
constexpr std::size_t n_pieces = 200;

TEST(ColouredSchedule, HoldEveryPieceOnceAndKnowWhoTouchedSomethingOfItLast) {
  const ColouredSchedule waves(n_pieces, 50, touched);
  std::vector<std::size_t> order(waves.pieces().begin(), waves.pieces().end()), all(n_pieces);
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::sort(order);
  EXPECT_EQ(order, all);
  std::vector<Index> last(50, -1);
  for (std::size_t k = 0; k < n_pieces; ++k) {
    std::set<Index> expected;
    for (const Index i : touched(waves.pieces()[k])) expected.insert(std::exchange(last[i], static_cast<Index>(k)));
    expected.erase(-1);
    expected.erase(static_cast<Index>(k));  // where 2 i is i
    const auto found = waves.predecessors_of(k);
    EXPECT_TRUE(std::ranges::equal(found, expected)) << "piece " << waves.pieces()[k];
  }
}

// Neighbours are far apart in the order, so that threads seldom wait: as few colours as greedy colouring needs.
TEST(ColouredSchedule, PutPiecesThatShareNothingNextToEachOther) {
  const ColouredSchedule chain(100, 101, [](std::size_t i) { return std::array{static_cast<Index>(i), static_cast<Index>(i + 1)}; });
  for (std::size_t k = 0; k < 100; ++k) EXPECT_EQ(chain.pieces()[k], k < 50 ? 2 * k : 2 * (k - 50) + 1);
}

TEST(ColouredSchedule, NeverWorkOnTheSameThingTwiceAtATimeAndKeepTheOrder) {
  set_n_threads(4);
  const ColouredSchedule waves(n_pieces, 50, touched);
  std::vector<std::atomic<int>> at_work(50);
  std::vector<std::vector<std::size_t>> visits(50), expected(50);
  for (const std::size_t piece : waves.pieces())
    for (const Index i : touched(piece)) expected[i].push_back(piece);
  waves.run([&](std::size_t piece) {
    for (const Index i : touched(piece)) {
      const std::size_t repeated = std::ranges::count(touched(piece), i);
      EXPECT_LE(at_work[i]++, static_cast<int>(repeated) - 1) << "piece " << piece;
      visits[i].push_back(piece);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(piece % 7 * 50));
    for (const Index i : touched(piece)) --at_work[i];
  });
  EXPECT_EQ(visits, expected);
  set_n_threads(0);
}

TEST(ColouredSchedule, EndWithTheFirstFailureAndLeaveNobodyWaiting) {
  set_n_threads(4);
  const ColouredSchedule waves(n_pieces, 50, touched);
  std::atomic<int> n_done = 0;
  EXPECT_THROW(waves.run([&](std::size_t piece) {
    if (piece == waves.pieces()[20]) throw std::runtime_error("it fails");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // time for the others to join in
    ++n_done;
  }), std::runtime_error);
  EXPECT_GE(n_done, 1);
  EXPECT_LT(n_done, 150);
  set_n_threads(0);
}

// All pieces want the same thing, and there are more of them than colours that are tried at once.
TEST(ColouredSchedule, AreAsManyAsItTakes) {
  const ColouredSchedule waves(150, 1, [](std::size_t) { return std::array{Index{0}}; });
  ASSERT_EQ(waves.pieces().size(), 150u);
  for (std::size_t k = 1; k < 150; ++k) EXPECT_TRUE(std::ranges::equal(waves.predecessors_of(k), std::array{static_cast<Index>(k - 1)}));
}

template <int Dim>
void check_rows() {
  const Octree<Dim> grid = hanging_grid<Dim>(0.3);
  const Unknowns<Dim> unknowns(grid, BoundaryCondition::neumann);
  const CellBlocks<Dim> cell_blocks(unknowns);
  ASSERT_GT(cell_blocks.size(), 1u) << "too few to tell";
  std::vector<std::size_t> n_places(unknowns.nodes().size(), 0), n_first(unknowns.nodes().size(), 0);
  std::size_t next = 0;
  std::mutex mutex;
  cell_blocks.for_each([&](const Chunk& cells) {
    const std::lock_guard lock(mutex);
    next += cells.end - cells.begin;
    EXPECT_LE(cells.end - cells.begin, cells_per_block(unknowns.elements().size()));
    const auto rows = cell_blocks.rows(cells.index);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      EXPECT_EQ(rows[r].is_first, n_places[rows[r].unknown] == 0);
      EXPECT_TRUE(r == 0 || rows[r - 1].unknown < rows[r].unknown);
      n_first[rows[r].unknown] += rows[r].is_first;
    }
    for (std::size_t e = cells.begin; e < cells.end; ++e)
      for (int c = 0; c < n_corners<Dim>; ++c) {
        const std::size_t row = cell_blocks.rows_of_corners(e)[c];
        const Index node = unknowns.elements()[e].nodes[c];
        if (row < rows.size()) {
          EXPECT_EQ(unknowns.nodes()[rows[row].unknown], node);
          ++n_places[rows[row].unknown];
        } else {
          const auto shares = cell_blocks.shares_of(cells.index, row - rows.size());
          const auto carriers = unknowns.carriers_of(node);
          ASSERT_EQ(shares.size(), carriers.size());
          for (std::size_t i = 0; i < shares.size(); ++i) {
            EXPECT_EQ(rows[shares[i].row].unknown, carriers[i].unknown);
            EXPECT_EQ(shares[i].weight, carriers[i].weight);
            ++n_places[carriers[i].unknown];
          }
        }
      }
  });
  EXPECT_EQ(next, unknowns.elements().size());
  for (std::size_t i = 0; i < n_places.size(); ++i) {
    EXPECT_EQ(n_places[i], unknowns.places_of(i).size());
    EXPECT_EQ(n_first[i], 1u);
  }
}
TEST(CellBlocks, ReachEveryPlaceOnce) {
  check_rows<2>();
  check_rows<3>();
}

}  // namespace
}  // namespace shellmatch::test
