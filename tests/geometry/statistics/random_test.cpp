// Random numbers: the standard's sequence, and distributions with the moments and frequencies that they must have.
#include "geometry/statistics/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace shellmatch {
namespace {

TEST(Random, UniformNumbersAreTheStandardsBits) {
  // [rand.predef]: the 10000th number of a default-seeded mt19937_64 is 9981545732273789042.
  Random random(std::mt19937_64::default_seed);
  for (int i = 1; i < 10000; ++i) random.uniform();
  EXPECT_EQ(random.uniform(), static_cast<double>(9981545732273789042u >> 11) / 9007199254740992.0);
}

TEST(Random, NormalNumbersHaveTheirMoments) {
  Random random(3);
  constexpr int n = 400'000;
  double sums[5] = {}, lagged = 0, before = 0;
  int n_beyond = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    for (int k = 1; k <= 4; ++k) sums[k] += std::pow(x, k) / n;
    lagged += x * before / n;
    before = x;
    n_beyond += std::abs(x) > 1.959964 ? 1 : 0;
  }
  // Five standard errors: the k-th power has variance E x^2k - (E x^k)^2.
  const double unit = 5 / std::sqrt(static_cast<double>(n));
  EXPECT_NEAR(sums[1], 0, unit);
  EXPECT_NEAR(sums[2], 1, unit * std::sqrt(2.0));
  EXPECT_NEAR(sums[3], 0, unit * std::sqrt(15.0));
  EXPECT_NEAR(sums[4], 3, unit * std::sqrt(96.0));
  EXPECT_NEAR(lagged, 0, unit);
  EXPECT_NEAR(n_beyond / static_cast<double>(n), 0.05, unit * std::sqrt(0.05 * 0.95));
}

TEST(Random, SameSeedSameNumbers) {
  Random a(7), b(7), c(8);
  bool differ = false;
  for (int i = 0; i < 100; ++i) {
    const double x = a.normal();
    EXPECT_EQ(x, b.normal());
    differ = differ || x != c.normal();
  }
  EXPECT_TRUE(differ);
}

TEST(Random, NumbersBelowALimitAreEquallyFrequent) {
  Random random(5);
  constexpr int n = 60'000;
  std::vector<int> counts(6);
  for (int i = 0; i < n; ++i) ++counts.at(random.below(6));
  for (const int count : counts) EXPECT_NEAR(count, n / 6.0, 5 * std::sqrt(n * 5 / 36.0));
  EXPECT_EQ(random.below(1), 0u);
  // Of the numbers below 3 * 2^62 a third is above 2^63; a remainder of 2^64 would make them a quarter.
  int n_above = 0;
  for (int i = 0; i < n; ++i)
    n_above += random.below(3u * (std::uint64_t{1} << 62)) >= (std::uint64_t{1} << 63) ? 1 : 0;
  EXPECT_NEAR(n_above, n / 3.0, 5 * std::sqrt(n * 2 / 9.0));
}

TEST(Random, ShufflesGiveEveryOrderEquallyOften) {
  Random random(11);
  constexpr int n = 48'000;
  std::map<std::vector<int>, int> counts;
  for (int i = 0; i < n; ++i) {
    std::vector<int> values{0, 1, 2, 3};
    random.shuffle(values);
    ++counts[values];
  }
  EXPECT_EQ(counts.size(), 24u);
  for (const auto& [order, count] : counts) EXPECT_NEAR(count, n / 24.0, 5 * std::sqrt(n / 24.0));
}

std::set<std::vector<double>> columns_of(const Splits& splits) {
  const Eigen::MatrixXd all = splits.indicators(0, splits.size());
  std::set<std::vector<double>> columns;
  for (Eigen::Index k = 0; k < all.cols(); ++k) columns.emplace(all.col(k).begin(), all.col(k).end());
  return columns;
}

TEST(Splits, AllDistinctOnesWhereThereAreFew) {
  const std::vector<char> is_b{1, 0, 1, 0, 0, 1};
  const Splits all(is_b, 20, 1);
  EXPECT_TRUE(all.are_all());
  EXPECT_EQ(all.size(), 20);
  const auto columns = columns_of(all);
  EXPECT_EQ(columns.size(), 20u);
  for (const auto& c : columns) EXPECT_EQ(std::count(c.begin(), c.end(), 1.0), 3);
  EXPECT_TRUE(columns.contains({1, 0, 1, 0, 0, 1}));
  EXPECT_EQ(Splits({0, 1, 1, 1, 1, 1, 1, 1, 1}, 9, 1).size(), 9);
}

TEST(Splits, RandomOnesBeginWithTheObserved) {
  const std::vector<char> is_b{1, 0, 1, 0, 0, 1};
  const Splits some(is_b, 19, 1), others(is_b, 19, 2);
  EXPECT_FALSE(some.are_all());
  EXPECT_EQ(some.size(), 19);
  EXPECT_EQ(some.indicators(0, 1), (Eigen::VectorXd{{1, 0, 1, 0, 0, 1}}));
  EXPECT_EQ(some.indicators(0, 19).colwise().sum(), Eigen::RowVectorXd::Constant(19, 3));
  EXPECT_EQ(some.indicators(4, 3), some.indicators(0, 19).middleCols(4, 3));
  EXPECT_EQ(some.indicators(0, 19), Splits(is_b, 19, 1).indicators(0, 19));
  EXPECT_NE(some.indicators(0, 19), others.indicators(0, 19));
  // 40 shapes have more splits than can be counted with 32 bits.
  EXPECT_EQ(Splits(std::vector<char>(100, 0), 10, 1).size(), 1);
  std::vector<char> many(2000, 0);
  std::fill(many.begin(), many.begin() + 1000, 1);
  EXPECT_EQ(Splits(many, 10, 1).size(), 10);
}

}  // namespace
}  // namespace shellmatch
