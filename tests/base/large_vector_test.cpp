#include "base/large_vector.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numeric>

namespace shellmatch {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;

bool begins_a_page(const void* p) { return reinterpret_cast<std::uintptr_t>(p) % large_page == 0; }

TEST(LargeVector, BeginsOnAPageIfLarge) {
  const LargeVector<double> large(large_page), copy = large;
  EXPECT_TRUE(begins_a_page(large.data()));
  EXPECT_TRUE(begins_a_page(copy.data()));
  // Many small ones cannot all begin on a page.
  std::array<LargeVector<double>, 8> small;
  bool all = true;
  for (auto& s : small) {
    s.resize(100);
    all = all && begins_a_page(s.data());
  }
  EXPECT_FALSE(all);
}

TEST(LargeVector, KeepsItsNumbersWhileItGrows) {
  LargeVector<int> v{1, 2, 3};
  while (v.size() < 2 * large_page) v.push_back(static_cast<int>(v.size()) + 1);
  const auto n = static_cast<std::int64_t>(v.size());
  EXPECT_EQ(std::accumulate(v.begin(), v.end(), std::int64_t{0}), n * (n + 1) / 2);
  LargeVector<int> moved = std::move(v);
  EXPECT_EQ(moved.back(), n);
  moved.resize(2);
  moved.shrink_to_fit();
  EXPECT_EQ(moved, (LargeVector<int>{1, 2}));
}

TEST(LargeVector, AlignsAsItsElementsWant) {
  struct alignas(64) Aligned {
    double x[8];
  };
  for (const std::size_t n : {std::size_t{1}, std::size_t{3}, 2 * large_page / sizeof(Aligned)}) {
    const LargeVector<Aligned> v(n);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(v.data()) % alignof(Aligned), 0u);
  }
}

TEST(LargeVector, FillsWithWhatItIsGiven) {
  const LargeVector<float> filled(large_page, 2.5f);
  for (const float x : filled) ASSERT_EQ(x, 2.5f);
  const LargeVector<std::vector<int>> of_vectors(10);  // what has a constructor is constructed
  for (const auto& v : of_vectors) EXPECT_TRUE(v.empty());
}

}  // namespace
}  // namespace shellmatch
