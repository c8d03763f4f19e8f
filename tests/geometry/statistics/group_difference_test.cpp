// Differences of groups: T^2 from its definition, permutations counted one by one, and rates of errors over many data
// sets.
#include "geometry/statistics/group_difference.h"

#include "base/error.h"
#include "tests/geometry/statistics/families.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace shellmatch {
namespace {

using testing::distance;
using testing::random_sets;
using testing::random_weights;

std::vector<char> last_are_b(Eigen::Index n, Eigen::Index n_b) {
  std::vector<char> is_b(static_cast<std::size_t>(n), 0);
  std::fill(is_b.end() - n_b, is_b.end(), 1);
  return is_b;
}

Eigen::VectorXd mean_of_group(const PointSets& sets, const std::vector<char>& is_b, bool b) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(sets.coordinates.rows());
  double n = 0;
  for (Eigen::Index i = 0; i < sets.n_sets(); ++i)
    if ((is_b[static_cast<std::size_t>(i)] != 0) == b) {
      sum += sets.coordinates.col(i);
      n += 1;
    }
  return sum / n;
}

// From the covariance of the groups about their own means and its inverse.
double hotelling(const PointSets& sets, const std::vector<char>& is_b, Eigen::Index point) {
  const int d = sets.dimension;
  const Eigen::VectorXd means[] = {mean_of_group(sets, is_b, false).segment(d * point, d),
                                   mean_of_group(sets, is_b, true).segment(d * point, d)};
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(d, d);
  double n_b = 0;
  const double n = static_cast<double>(sets.n_sets());
  for (Eigen::Index i = 0; i < sets.n_sets(); ++i) {
    const bool b = is_b[static_cast<std::size_t>(i)] != 0;
    n_b += b ? 1 : 0;
    const Eigen::VectorXd x = sets.coordinates.col(i).segment(d * point, d) - means[b ? 1 : 0];
    covariance += x * x.transpose() / (n - 2);
  }
  const Eigen::VectorXd difference = means[1] - means[0];
  return n_b * (n - n_b) / n * difference.dot(covariance.inverse() * difference);
}

TEST(GroupDifference, StatisticIsHotellings) {
  for (const int dimension : {2, 3}) {
    const PointSets sets = random_sets(dimension, 150, 17, 3, 5);
    const Eigen::VectorXd weights = random_weights(150, 4);
    std::vector<char> is_b(17, 0);
    for (const std::size_t i : {1u, 2u, 5u, 8u, 13u, 16u}) is_b[i] = 1;
    const GroupDifference result = group_difference(sets, weights, is_b, 50, 1);
    EXPECT_EQ(result.n_a, 11);
    EXPECT_EQ(result.n_b, 6);
    EXPECT_EQ(result.n_permutations, 50);
    EXPECT_FALSE(result.all_permutations);
    for (Eigen::Index p = 0; p < 150; ++p) {
      const double direct = hotelling(sets, is_b, p);
      EXPECT_NEAR(result.statistic[p], direct, 1e-10 * direct) << p;
    }
    const Eigen::VectorXd difference = mean_of_group(sets, is_b, true) - mean_of_group(sets, is_b, false);
    EXPECT_LE((result.difference - difference).norm(), 1e-12);
    EXPECT_NEAR(result.distance, distance(difference, Eigen::VectorXd::Zero(difference.size()), weights), 1e-13);
  }
}

// 3 + 3: all 20 splits, each computed from the definition.
TEST(GroupDifference, OfSmallGroupsIsExact) {
  PointSets sets = random_sets(3, 40, 6, 13);
  for (Eigen::Index p = 0; p < 10; ++p) sets.coordinates.block(3 * p, 3, 1, 3).array() += 6;
  const Eigen::VectorXd weights = random_weights(40, 14);
  const std::vector<char> is_b = last_are_b(6, 3);
  std::vector<std::vector<char>> splits;
  std::vector<char> split = is_b;  // the first in lexicographic order
  do splits.push_back(split);
  while (std::next_permutation(split.begin(), split.end()));
  ASSERT_EQ(splits.size(), 20u);
  const GroupDifference result = group_difference(sets, weights, is_b, 1000, 1),
                        other_seed = group_difference(sets, weights, is_b, 20, 2);
  EXPECT_TRUE(result.all_permutations);
  EXPECT_EQ(result.n_permutations, 20);
  constexpr double equal = 1 - 1e-9;
  std::vector<double> greatest(20, 0), distances(20);
  Eigen::MatrixXd statistics(40, 20);
  for (std::size_t s = 0; s < 20; ++s) {
    for (Eigen::Index p = 0; p < 40; ++p) {
      statistics(p, static_cast<Eigen::Index>(s)) = hotelling(sets, splits[s], p);
      greatest[s] = std::max(greatest[s], statistics(p, static_cast<Eigen::Index>(s)));
    }
    distances[s] = distance(mean_of_group(sets, splits[s], true), mean_of_group(sets, splits[s], false), weights);
  }
  for (Eigen::Index p = 0; p < 40; ++p) {
    const double observed = statistics(p, 0);
    EXPECT_DOUBLE_EQ(result.p[p], static_cast<double>((statistics.row(p).array() >= observed * equal).count()) / 20);
    const auto n_greater =
        std::count_if(greatest.begin(), greatest.end(), [&](double g) { return g >= observed * equal; });
    EXPECT_DOUBLE_EQ(result.p_corrected[p], static_cast<double>(n_greater) / 20);
    EXPECT_GE(result.p[p], 0.1);  // a split and its complement have the same statistic
  }
  EXPECT_DOUBLE_EQ(result.global_p,
                   static_cast<double>(std::count_if(distances.begin(), distances.end(),
                                                     [&](double d) { return d >= distances[0] * equal; })) /
                       20);
  EXPECT_EQ(result.p, other_seed.p);
  EXPECT_EQ(result.p.minCoeff(), 0.1);
}

// Neighbours alike, as on a surface: sums of three independent fields.
PointSets smooth_sets(Eigen::Index n_points, Eigen::Index n_sets, std::uint64_t seed) {
  const PointSets noise = random_sets(3, n_points + 2, n_sets, seed);
  const Eigen::Index rows = 3 * n_points;
  return {3,
          noise.coordinates.topRows(rows) + noise.coordinates.middleRows(3, rows) + noise.coordinates.bottomRows(rows)};
}

TEST(GroupDifference, ErrorRatesWithoutDifference) {
  constexpr int n_data = 200, n_points = 40;
  const Eigen::VectorXd weights = uniform_weights(n_points);
  int n_family = 0, n_global = 0, n_pointwise = 0, n_discoveries = 0;
  double sum_of_p = 0;
  for (int data = 0; data < n_data; ++data) {
    const GroupDifference result =
        group_difference(smooth_sets(n_points, 14, 1000 + data), weights, last_are_b(14, 6), 100, 7);
    n_family += result.p_corrected.minCoeff() <= 0.05 ? 1 : 0;
    n_global += result.global_p <= 0.05 ? 1 : 0;
    n_discoveries += result.q.minCoeff() <= 0.05 ? 1 : 0;
    n_pointwise += static_cast<int>((result.p.array() <= 0.05).count());
    sum_of_p += result.p.mean();
    EXPECT_TRUE((result.p_corrected.array() >= result.p.array()).all());
    EXPECT_TRUE((result.q.array() >= result.p.array()).all());
  }
  // The rates are 5 %, with a standard error of 1.5 % over 200 data sets.
  EXPECT_GE(n_family, 0.02 * n_data);
  EXPECT_LE(n_family, 0.09 * n_data);
  EXPECT_GE(n_global, 0.02 * n_data);
  EXPECT_LE(n_global, 0.09 * n_data);
  EXPECT_LE(n_discoveries, 0.09 * n_data);
  EXPECT_NEAR(n_pointwise / static_cast<double>(n_data * n_points), 0.05, 0.01);
  EXPECT_NEAR(sum_of_p / n_data, 0.505, 0.03);  // of 1/100, 2/100, ..., 1
}

TEST(GroupDifference, APlantedDifferenceIsFoundWhereItIs) {
  constexpr Eigen::Index n_points = 300;
  PointSets sets = smooth_sets(n_points, 30, 5);
  for (Eigen::Index p = 100; p < 120; ++p) sets.coordinates.block(3 * p + 1, 15, 1, 15).array() += 4.5;
  const Eigen::VectorXd weights = uniform_weights(n_points);
  const GroupDifference result = group_difference(sets, weights, last_are_b(30, 15), 1000, 6);
  for (Eigen::Index p = 0; p < n_points; ++p) {
    const bool planted = p >= 100 && p < 120;
    EXPECT_EQ(result.p_corrected[p] <= 0.05, planted) << p;
    if (planted) {
      EXPECT_LE(result.q[p], 0.05);
      EXPECT_NEAR(result.difference[3 * p + 1], 4.5, 2.5);
    }
  }
  EXPECT_LE(result.global_p, 0.05);
}

// Points that do not move, move on a line or in a plane; groups that do not vary.
TEST(GroupDifference, OfPointsThatHardlyMove) {
  PointSets sets = random_sets(3, 6, 12, 15, 100);
  const std::vector<char> is_b = last_are_b(12, 5);
  const PointSets line = random_sets(2, 1, 12, 16, 100);
  for (Eigen::Index i = 0; i < 12; ++i) {
    auto x = sets.coordinates.col(i);
    x.segment<3>(0) << 0.1, 0.2, 300.0 / 7;                                                     // equal
    x.segment<3>(3) << 100 / 3.0 + 1e-14 * static_cast<double>(i % 3), 0.2, 0.3;                // equal to rounding
    x.segment<3>(6) << 0.1, line.coordinates(0, i), 0.3;                                        // on a line
    x.segment<3>(9) << line.coordinates(0, i), line.coordinates(1, i), line.coordinates(0, i);  // in a plane
    x.segment<3>(12) << 0.1, is_b[static_cast<std::size_t>(i)] != 0 ? 1 : 0, 0.3;  // the groups do not vary
  }
  const GroupDifference result = group_difference(sets, uniform_weights(6), is_b, 500, 1);
  EXPECT_EQ(result.statistic[0], 0);
  EXPECT_EQ(result.statistic[1], 0);
  EXPECT_EQ(result.p[0], 1);
  EXPECT_EQ(result.p_corrected[1], 1);
  // Student's t squared, and T^2 of the plane.
  double sums[2] = {}, squares = 0;
  for (Eigen::Index i = 0; i < 12; ++i) sums[i < 7 ? 0 : 1] += line.coordinates(0, i) / (i < 7 ? 7 : 5);
  for (Eigen::Index i = 0; i < 12; ++i) squares += std::pow(line.coordinates(0, i) - sums[i < 7 ? 0 : 1], 2) / 10;
  EXPECT_NEAR(result.statistic[2], 35 / 12.0 * std::pow(sums[1] - sums[0], 2) / squares, 1e-8);
  EXPECT_NEAR(result.statistic[3], hotelling(line, is_b, 0), 1e-8 * result.statistic[3]);
  EXPECT_NEAR(result.statistic[4], 10 / 1e-11, 1e-9 * 1e12);
  EXPECT_LE(result.p_corrected[4], 3 / 500.0);
}

TEST(GroupDifference, FalseDiscoveryRates) {
  // The example of Benjamini and Hochberg (1995): 15 tests, of which four are discoveries at 0.05.
  const Eigen::VectorXd p{{0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344, 0.0459, 0.3240, 0.4262,
                           0.5719, 0.6528, 0.7590, 1.0000}};
  const Eigen::VectorXd q = false_discovery_rates(p);
  EXPECT_EQ((q.array() <= 0.05).count(), 4);
  EXPECT_NEAR(q[3], 0.0095 * 15 / 4, 1e-15);
  EXPECT_NEAR(q[5], 0.0298 * 15 / 7, 1e-15);  // of a greater p with a smaller rate
  EXPECT_EQ(q[14], 1);
  const Eigen::VectorXd unordered{{0.5, 0.01, 0.5, 0.02}};
  EXPECT_LE((false_discovery_rates(unordered) - Eigen::VectorXd{{0.5, 0.04, 0.5, 0.04}}).norm(), 1e-15);
}

std::string error_of_groups(const PointSets& sets, const std::vector<char>& is_b, int n_permutations = 10) {
  try {
    group_difference(sets, uniform_weights(sets.n_points()), is_b, n_permutations, 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

TEST(GroupDifference, SaysWhatIsWrong) {
  EXPECT_NE(error_of_groups(random_sets(3, 5, 6, 1), last_are_b(6, 1)).find("groups of 5 and 1 shapes"),
            std::string::npos);
  EXPECT_NE(error_of_groups(random_sets(3, 5, 6, 1), last_are_b(6, 6)).find("groups of 0 and 6 shapes"),
            std::string::npos);
  EXPECT_NE(error_of_groups(random_sets(3, 5, 4, 1), last_are_b(4, 2)).find("5 in both"), std::string::npos);
  EXPECT_EQ(error_of_groups(random_sets(3, 5, 5, 1), last_are_b(5, 2)), "no InputError");
  EXPECT_EQ(error_of_groups(random_sets(2, 5, 4, 1), last_are_b(4, 2)), "no InputError");
  EXPECT_EQ(error_of_groups(random_sets(3, 1, 6, 1), last_are_b(6, 3)), "no InputError");
  EXPECT_NE(error_of_groups(random_sets(3, 5, 6, 1), last_are_b(7, 3)).find("7 memberships of groups for 6 shapes"),
            std::string::npos);
  EXPECT_NE(error_of_groups(random_sets(3, 5, 6, 1), last_are_b(6, 3), 0).find("0 permutations"), std::string::npos);
  PointSets broken = random_sets(3, 5, 6, 1);
  broken.coordinates(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(error_of_groups(broken, last_are_b(6, 3)).find("shape 0, point 0"), std::string::npos);
}

}  // namespace
}  // namespace shellmatch
