// Nearest neighbours against the definition, with few rows and with many, where clusters are left out.
#include "alignment/functional_map/nearest_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace shellmatch {
namespace {

Features random_features(Eigen::Index rows, Eigen::Index cols, unsigned seed) {
  std::mt19937 random(seed);
  Features features(rows, cols);
  for (Eigen::Index j = 0; j < cols; ++j)
    for (Eigen::Index i = 0; i < rows; ++i) features(i, j) = static_cast<float>(random() / 4294967296.0 - 0.5);
  return features;
}

/// Points of a curve in a space of many dimensions, some way off.
Features along_a_curve(Eigen::Index rows, Eigen::Index cols, double noise, unsigned seed) {
  Features features = static_cast<float>(noise) * random_features(rows, cols, seed);
  for (Eigen::Index j = 0; j < cols; ++j)
    for (Eigen::Index i = 0; i < rows; ++i)
      features(i, j) += static_cast<float>(
          std::cos(7.0 * static_cast<double>(j) / static_cast<double>(cols) * static_cast<double>(i)));
  return features;
}

void expect_nearest(const Features& targets, const Features& queries) {
  const std::vector<Index> nearest = nearest_features(targets, queries);
  ASSERT_EQ(nearest.size(), static_cast<std::size_t>(queries.cols()));
  for (Eigen::Index q = 0; q < queries.cols(); ++q) {
    const Eigen::VectorXf squares = (targets.colwise() - queries.col(q)).colwise().squaredNorm();
    EXPECT_LE(squares[nearest[static_cast<std::size_t>(q)]],
              squares.minCoeff() + 1e-6f * static_cast<float>(targets.rows()));
  }
  // An order is a matter of time alone.
  std::vector<Index> reversed = compact_order(targets);
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(nearest_features(targets, queries, reversed), nearest);
}

TEST(NearestFeatures, AreTheNearestOfAll) {
  // Numbers of columns that leave a rest of the blocks, and one that fills none.
  for (const auto& [n_targets, n_queries] : {std::pair(1300, 130), std::pair(512, 64), std::pair(3, 1)})
    for (const Eigen::Index rows : {1, 13, 32, 33, 70}) {
      expect_nearest(random_features(rows, n_targets, 1), random_features(rows, n_queries, 2));
      expect_nearest(along_a_curve(rows, n_targets, 0.1, 1), along_a_curve(rows, n_queries, 0.1, 2));
    }
}

TEST(NearestFeatures, OfTargetsWithEqualDistancesTheFirst) {
  for (const Eigen::Index rows : {8, 80}) {
    const Features some = random_features(rows, 300, 3);
    Features targets(rows, 3 * 300);
    targets << some, some, some;
    const std::vector<Index> nearest = nearest_features(targets, some);
    for (std::size_t q = 0; q < nearest.size(); ++q) EXPECT_EQ(nearest[q], static_cast<Index>(q));
  }
}

TEST(NearestFeatures, ACompactOrderHasAllOnceAndNeighboursTogether) {
  const Features features = along_a_curve(5, 1000, 0, 1);
  const std::vector<Index> order = compact_order(features);
  std::vector<Index> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], static_cast<Index>(i));
  double ordered = 0, unordered = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    ordered += (features.col(order[i]) - features.col(order[i - 1])).norm();
    unordered += (features.col(order[i]) - features.col(order[order.size() / 2])).norm();
  }
  EXPECT_LT(ordered, 0.2 * unordered);
}

}  // namespace
}  // namespace shellmatch
