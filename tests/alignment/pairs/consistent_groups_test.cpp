// Patches that a map takes elsewhere than what is around them.
#include "alignment/pairs/confident_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace shellmatch {
namespace {

/// A strip of 20 by 5 points at a distance of 0.1.
std::vector<Vec<3>> strip(const Vec<3>& corner = Vec<3>::Zero()) {
  std::vector<Vec<3>> points;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 5; ++j) points.emplace_back(corner[0] + 0.1 * i, corner[1] + 0.1 * j, corner[2]);
  return points;
}

/// With the nearest six as neighbours.
std::vector<bool> consistent(const std::vector<Vec<3>>& from, const std::vector<Vec<3>>& to) {
  NeighbourLists nearest(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t j = 0; j < from.size(); ++j)
      if (j != i) nearest[i].emplace_back((from[j] - from[i]).norm(), j);
    std::ranges::sort(nearest[i]);
    nearest[i].resize(std::min<std::size_t>(nearest[i].size(), 6));
  }
  return in_consistent_group(nearest, to, 3, 0.03);
}

TEST(ConsistentGroups, APatchOnAnotherLimbContradicts) {
  const std::vector<Vec<3>> from = strip();
  std::vector<Vec<3>> to = from;
  for (std::size_t i = 40; i < 47; ++i) to[i] += Vec<3>(0, 0, 1);
  const std::vector<bool> found = consistent(from, to);
  for (std::size_t i = 0; i < from.size(); ++i) EXPECT_EQ(found[i], i < 40 || i >= 47) << i;
}

TEST(ConsistentGroups, OfTwoHalvesTheLargerStays) {
  const std::vector<Vec<3>> from = strip();
  std::vector<Vec<3>> to = from;
  for (std::size_t i = 0; i < 45; ++i) to[i] += Vec<3>(0, 0, 1);
  const std::vector<bool> found = consistent(from, to);
  for (std::size_t i = 0; i < from.size(); ++i) EXPECT_EQ(found[i], i >= 45) << i;
}

TEST(ConsistentGroups, AStretchWithinTheLimitAndErrorsContradictNothing) {
  const std::vector<Vec<3>> from = strip();
  std::vector<Vec<3>> to = from;
  for (Vec<3>& x : to) x *= 2.5;
  // A way of 0.35 is within 3 (0.1 + 0.03), one of 0.45 is not.
  for (std::size_t i = 50; i < 100; ++i) to[i] += Vec<3>(0.1, 0, 0);
  EXPECT_THAT(consistent(from, to), testing::Each(true));
  for (std::size_t i = 50; i < 100; ++i) to[i] += Vec<3>(0.1, 0, 0);
  const std::vector<bool> found = consistent(from, to);
  EXPECT_EQ(std::ranges::count(found, true), 100) << "halves of one size";
  to[0] += Vec<3>(0, 0, 1);
  EXPECT_EQ(std::ranges::count(consistent(from, to), true), 50);
}

TEST(ConsistentGroups, PartsThatAreFarFromEachOtherAreJudgedAlone) {
  std::vector<Vec<3>> from = strip(), to = from;
  for (const Vec<3>& x : strip({0, 0, 5})) {
    from.push_back(x);
    to.push_back(x + Vec<3>(0, 7, 0));
  }
  from.resize(130);
  to.resize(130);
  EXPECT_THAT(consistent(from, to), testing::Each(true));
  to[3][2] += 1;
  EXPECT_EQ(std::ranges::count(consistent(from, to), false), 1);
}

TEST(ConsistentGroups, NoPointsAndOneAreNoTrouble) {
  EXPECT_TRUE(consistent({}, {}).empty());
  EXPECT_EQ(consistent({Vec<3>(1, 2, 3)}, {Vec<3>(4, 5, 6)}), std::vector<bool>{true});
}

}  // namespace
}  // namespace shellmatch
