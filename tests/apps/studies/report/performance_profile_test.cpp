#include "apps/studies/report/convergence.h"

#include "base/types.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

// Three problems, by hand: the best is 1, 2, 4.
TEST(PerformanceProfile, ByHand) {
  const auto profiles = performance_profiles({{1, 2}, {6, 2}, {4, infinity}});
  ASSERT_EQ(profiles.size(), 2u);
  EXPECT_DOUBLE_EQ(profiles[0].at(0.9), 0);
  EXPECT_DOUBLE_EQ(profiles[0].at(1), 2.0 / 3);
  EXPECT_DOUBLE_EQ(profiles[0].at(2.9), 2.0 / 3);
  EXPECT_DOUBLE_EQ(profiles[0].at(3), 1);
  EXPECT_DOUBLE_EQ(profiles[1].at(1), 1.0 / 3);
  EXPECT_DOUBLE_EQ(profiles[1].at(2), 2.0 / 3);
  EXPECT_DOUBLE_EQ(profiles[1].at(1e9), 2.0 / 3);
}

TEST(PerformanceProfile, AnUnsolvedProblemCountsForAll) {
  const auto profiles = performance_profiles({{1, 1}, {infinity, infinity}});
  for (const auto& profile : profiles) EXPECT_DOUBLE_EQ(profile.at(1e9), 0.5);
}

// On random costs: by the definition, monotone, scale-free, and somebody is the best of every solved problem.
TEST(PerformanceProfile, HoldsWhatTheDefinitionPromises) {
  std::mt19937 random(7);
  std::uniform_real_distribution<> uniform(0.5, 50);
  std::vector<std::vector<double>> costs(9, std::vector<double>(4));
  for (auto& row : costs)
    for (double& c : row) c = uniform(random) < 10 ? infinity : uniform(random);
  const auto profiles = performance_profiles(costs);
  for (const double tau : {1.0, 1.3, 2.0, 7.0, 100.0}) {
    double at_best = 0;
    for (std::size_t s = 0; s < 4; ++s) {
      int n = 0;
      for (const auto& row : costs) n += row[s] <= tau * *std::min_element(row.begin(), row.end()) && row[s] < infinity;
      EXPECT_DOUBLE_EQ(profiles[s].at(tau), n / 9.0);
      at_best += profiles[s].at(1);
    }
    EXPECT_GE(at_best, 1 - 1e-12);
  }
  for (auto& row : costs)
    for (double& c : row) c *= 8;
  const auto scaled = performance_profiles(costs);
  for (std::size_t s = 0; s < 4; ++s) EXPECT_EQ(scaled[s].ratio, profiles[s].ratio);
}

}  // namespace
}  // namespace shellmatch
