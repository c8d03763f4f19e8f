// Dynamic programming against all paths there are, and against warps that are known.
#include "alignment/outline/elastic_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace shellmatch {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// The least cost of the steps from (i, j) behind the first pair to (n, n), by trying all.
double least_of_all(const Eigen::MatrixXd& costs, std::size_t first, std::size_t second, double stretching,
                    std::size_t i, std::size_t j) {
  const auto n = static_cast<std::size_t>(costs.rows());
  if (i == n && j == n) return 0;
  double least = inf;
  for (const auto& [a, b] : {std::array{1, 1}, {1, 2}, {2, 1}, {1, 3}, {3, 1}, {2, 3}, {3, 2}}) {
    const std::size_t to_i = i + a, to_j = j + b;
    if (to_i > n || to_j > n) continue;
    const double penalty = stretching * std::pow(std::log(static_cast<double>(a) / b), 2);
    least = std::min(least, 0.5 * (a + b) * (costs((first + to_i) % n, (second + to_j) % n) + penalty) +
                                least_of_all(costs, first, second, stretching, to_i, to_j));
  }
  return least;
}

TEST(ElasticPath, IsTheCheapestOfAll) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::MatrixXd costs(7, 7);
    for (double& c : costs.reshaped()) c = static_cast<double>(random() % 1000) / 1000;
    const std::size_t first = random() % 7, second = random() % 7;
    double total = 0;
    const ElasticPath path = elastic_path(costs, first, second, 0.1, &total);
    EXPECT_NEAR(7 * total, least_of_all(costs, first, second, 0.1, 0, 0), 1e-12);
    ASSERT_FALSE(path.empty());
    EXPECT_EQ(path.back(), std::pair(first, second));
    // The cost of the path that is returned is the one that is told.
    double sum = 0;
    for (std::size_t k = 0; k < path.size(); ++k) {
      const auto [i, j] = path[k];
      const auto [last_i, last_j] = path[(k + path.size() - 1) % path.size()];
      const auto a = static_cast<double>((i + 6 - last_i) % 7 + 1), b = static_cast<double>((j + 6 - last_j) % 7 + 1);
      sum += 0.5 * (a + b) * (costs(i, j) + 0.1 * std::pow(std::log(a / b), 2));
    }
    EXPECT_NEAR(7 * total, sum, 1e-12);
  }
}

TEST(ElasticPath, FindsAWarpFromAWrongFirstPair) {
  const std::size_t n = 120;
  const auto warp = [&](double i) { return i + 8 * std::sin(2 * M_PI * i / n); };
  const auto feature = [&](double i) {
    return std::array{std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), std::sin(6 * M_PI * i / n)};
  };
  Eigen::MatrixXd costs(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const auto a = feature(warp(static_cast<double>(i))), b = feature(static_cast<double>(j));
      costs(i, j) = std::pow(a[0] - b[0], 2) + std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2);
    }
  const auto largest_error = [&](const ElasticPath& path) {
    double largest = 0;
    for (const auto& [i, j] : path) {
      const double off = std::abs(warp(static_cast<double>(i)) - static_cast<double>(j));
      largest = std::max(largest, std::min(off, n - off));
    }
    return largest;
  };
  EXPECT_LT(largest_error(closed_elastic_path(costs, 10, 18, 1e-4)), 1.01);
  EXPECT_GT(largest_error(elastic_path(costs, 10, 18, 1e-4)), 3);
}

TEST(ElasticPath, InfiniteCostsAreNoPairs) {
  Eigen::MatrixXd costs = Eigen::MatrixXd::Zero(9, 9);
  costs.row(4).setConstant(inf);
  const ElasticPath path = elastic_path(costs, 0, 0, 0.01);
  ASSERT_FALSE(path.empty());
  EXPECT_TRUE(std::none_of(path.begin(), path.end(), [](const auto& pair) { return pair.first == 4; }));
  costs.middleRows(4, 3).setConstant(inf);
  EXPECT_TRUE(elastic_path(costs, 0, 0, 0.01).empty());
  EXPECT_TRUE(closed_elastic_path(costs, 0, 0, 0.01).empty());
}

}  // namespace
}  // namespace shellmatch
