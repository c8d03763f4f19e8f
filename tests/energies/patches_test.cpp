// Patches of elements and the waves in which they are worked off.

#include "energies/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <numeric>

#include "tests/energies/matching_problem.h"

namespace shellmatch::test {
namespace {

// Pieces as told by run(): wave after wave, as far as they can be told apart by what they touch.
std::vector<std::size_t> order_of(const Waves& waves) {
  std::vector<std::size_t> order;
  std::mutex mutex;
  waves.run([&](std::size_t piece) {
    const std::lock_guard lock(mutex);
    order.push_back(piece);
  });
  return order;
}

TEST(Waves, HoldEveryPieceOnceAndNothingTwiceAtATime) {
  // Piece i touches i, 2 i and 3 i modulo 50.
  constexpr std::size_t n = 200;
  std::vector<std::vector<Index>> touched(n);
  for (std::size_t i = 0; i < n; ++i)
    for (const std::size_t factor : {1, 2, 3}) touched[i].push_back(static_cast<Index>(factor * i % 50));
  const Waves waves(n, 50, [&](std::size_t i) -> const std::vector<Index>& { return touched[i]; });
  std::vector<std::size_t> order = order_of(waves);
  std::ranges::sort(order);
  std::vector<std::size_t> all(n);
  std::iota(all.begin(), all.end(), std::size_t{0});
  EXPECT_EQ(order, all);
  std::size_t begin = 0;
  for (const std::size_t end : waves.ends()) {
    std::vector<char> is_touched(50, 0);
    for (std::size_t p = begin; p < end; ++p) {
      std::vector<Index> once = touched[waves.pieces()[p]];
      std::ranges::sort(once);
      const auto repeated = std::ranges::unique(once);
      once.erase(repeated.begin(), repeated.end());
      for (const Index i : once) EXPECT_FALSE(is_touched[i]++) << "piece " << waves.pieces()[p];
    }
    begin = end;
  }
  EXPECT_EQ(begin, n);
  EXPECT_LT(waves.ends().size(), 64u);
}

// All pieces want the same thing, and there are more of them than colours that are tried at once.
TEST(Waves, AreAsManyAsItTakes) {
  const std::vector<Index> same{0};
  const Waves waves(150, 1, [&](std::size_t) -> const std::vector<Index>& { return same; });
  EXPECT_EQ(waves.ends().size(), 150u);
  EXPECT_EQ(order_of(waves).size(), 150u);
}

template <int Dim>
void check_rows() {
  const Octree<Dim> grid = hanging_grid<Dim>(0.3);
  const Unknowns<Dim> unknowns(grid, BoundaryCondition::neumann);
  const Patches<Dim> patches(unknowns);
  ASSERT_GT(patches.size(), 1u) << "too few to tell";
  std::vector<std::size_t> n_places(unknowns.nodes().size(), 0), n_first(unknowns.nodes().size(), 0);
  std::size_t next = 0;
  std::mutex mutex;
  patches.for_each([&](const Chunk& patch) {
    const std::lock_guard lock(mutex);
    next += patch.end - patch.begin;
    EXPECT_LE(patch.end - patch.begin, elements_per_patch(unknowns.elements().size()));
    for (const auto& row : patches.rows(patch.index)) {
      EXPECT_EQ(row.is_first, n_places[row.unknown] == 0);
      for (const auto& place : patches.places_of(row)) {
        const auto element = static_cast<std::size_t>(place.element_corner) / n_corners<Dim>;
        EXPECT_TRUE(patch.begin <= element && element < patch.end);
        ++n_places[row.unknown];
      }
      n_first[row.unknown] += row.is_first;
    }
  });
  EXPECT_EQ(next, unknowns.elements().size());
  for (std::size_t i = 0; i < n_places.size(); ++i) {
    EXPECT_EQ(n_places[i], unknowns.places_of(i).size());
    EXPECT_EQ(n_first[i], 1u);
  }
}
TEST(Patches, ReachEveryPlaceOnce) {
  check_rows<2>();
  check_rows<3>();
}

}  // namespace
}  // namespace shellmatch::test
