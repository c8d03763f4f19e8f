// Starts: all signs, and orders of close eigenvalues.
#include "alignment/functional_map/starts.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace shellmatch {
namespace {

std::set<std::vector<double>> as_set(const std::vector<Eigen::MatrixXd>& maps) {
  std::set<std::vector<double>> set;
  for (const Eigen::MatrixXd& c : maps) set.emplace(c.data(), c.data() + c.size());
  return set;
}

TEST(Starts, AllSignsOfDistinctEigenvaluesOnce) {
  const Eigen::VectorXd values = (Eigen::VectorXd(7) << 0, 1, 2, 4, 8, 16, 32).finished();
  const std::vector<Eigen::MatrixXd> maps = start_maps(values, values, 5, 1.35);
  EXPECT_EQ(maps.size(), 32u);
  EXPECT_EQ(as_set(maps).size(), 32u);
  EXPECT_EQ(maps[0], Eigen::MatrixXd::Identity(6, 6));
  for (const Eigen::MatrixXd& c : maps) {
    EXPECT_EQ(c(0, 0), 1);
    EXPECT_EQ(c * c.transpose(), Eigen::MatrixXd::Identity(6, 6));
  }
}

TEST(Starts, CloseNeighboursAreSwapped) {
  // 1 and 2 are close on the first surface, 3 and 4 on the second: four orders. 2 and 3 are apart on both.
  const Eigen::VectorXd first = (Eigen::VectorXd(6) << 0, 1, 1.2, 4, 8, 16).finished();
  const Eigen::VectorXd second = (Eigen::VectorXd(6) << 0, 1, 2, 4, 4.1, 16).finished();
  const std::vector<Eigen::MatrixXd> maps = start_maps(first, second, 4, 1.35);
  EXPECT_EQ(maps.size(), 4u * 16u);
  const auto set = as_set(maps);
  EXPECT_EQ(set.size(), maps.size());
  Eigen::MatrixXd swapped = Eigen::MatrixXd::Identity(5, 5);
  swapped.col(1).swap(swapped.col(2));
  EXPECT_TRUE(set.contains({swapped.data(), swapped.data() + swapped.size()}));
  swapped.col(3).swap(swapped.col(4));
  EXPECT_TRUE(set.contains({swapped.data(), swapped.data() + swapped.size()}));
}

TEST(Starts, NeighboursThatOverlapAreSwappedOneAtATime) {
  // 1, 2, 3 are all close: the identity, (1 2) and (2 3).
  const Eigen::VectorXd values = (Eigen::VectorXd(5) << 0, 1, 1.1, 1.2, 8).finished();
  EXPECT_EQ(start_maps(values, values, 3, 1.35).size(), 3u * 8u);
}

TEST(Starts, ASphereHasNoAxesAndASolidOfRevolutionHasOne) {
  const auto with = [](double second, double third) {
    return Eigen::VectorXd((Eigen::VectorXd(5) << 0, 1, second, third, 3).finished());
  };
  EXPECT_TRUE(has_no_axes(with(1.0001, 1.0002)));
  EXPECT_FALSE(has_no_axes(with(1, 1.1)));
  EXPECT_FALSE(has_no_axes(with(1.1, 1.1)));
}

}  // namespace
}  // namespace shellmatch
