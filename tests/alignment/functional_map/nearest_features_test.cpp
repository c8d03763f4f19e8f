// Nearest neighbours by matrix products against the definition.
#include "alignment/functional_map/nearest_features.h"

#include <gtest/gtest.h>

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

TEST(NearestFeatures, AreTheNearestOfAll) {
  // Numbers of columns that leave a rest of the blocks, and one that fills none.
  for (const auto& [n_targets, n_queries] : {std::pair(1300, 130), std::pair(512, 64), std::pair(3, 1)}) {
    const Features targets = random_features(13, n_targets, 1), queries = random_features(13, n_queries, 2);
    const std::vector<Index> nearest = nearest_features(targets, queries);
    ASSERT_EQ(nearest.size(), static_cast<std::size_t>(n_queries));
    for (Eigen::Index q = 0; q < n_queries; ++q) {
      Eigen::Index expected = 0;
      (targets.colwise() - queries.col(q)).colwise().squaredNorm().minCoeff(&expected);
      EXPECT_EQ(nearest[static_cast<std::size_t>(q)], expected);
    }
  }
}

TEST(NearestFeatures, OfTargetsWithEqualDistancesTheFirst) {
  // A product's rounding depends on its place in a block, so that copies stand at the same places.
  const Features some = random_features(8, 512, 3);
  Features targets(8, 3 * 512);
  targets << some, some, some;
  const std::vector<Index> nearest = nearest_features(targets, some);
  for (std::size_t q = 0; q < nearest.size(); ++q) EXPECT_EQ(nearest[q], static_cast<Index>(q));
}

}  // namespace
}  // namespace shellmatch
