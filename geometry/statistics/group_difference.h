#pragma once
/// \file
/// Where two groups of shapes differ: permutation tests at every point.

#include "geometry/statistics/point_sets.h"

#include <cstdint>
#include <vector>

namespace shellmatch {

/// Of group B against group A.
struct GroupDifference {
  int n_a = 0, n_b = 0;
  int n_permutations = 0;         ///< with the observed one
  bool all_permutations = false;  ///< every distinct one: p is exact, whatever the seed
  Eigen::VectorXd difference;     ///< mean of B minus mean of A; dimension * V
  Eigen::VectorXd statistic;      ///< Hotelling's T^2 at every point; V
  Eigen::VectorXd p;              ///< share of permutations with at least this statistic at that point; V
  Eigen::VectorXd
      p_corrected;      ///< of those whose greatest statistic is: family-wise error (Westfall and Young 1993); V
  Eigen::VectorXd q;    ///< false discovery rate of `p` (Benjamini and Hochberg 1995); V
  double distance = 0;  ///< of the two means, root mean square over the surface
  double global_p = 1;  ///< permutation test of `distance`
};

/// With the difference d of the means at a point and the covariance C of both groups about their own means,
/// n_a + n_b - 2 in its denominator,
///     T^2 = n_a n_b / (n_a + n_b) d^T C^-1 d.
/// The covariance T of all about one mean does not change with the groups, and T^2 = (n - 2) s / (1 - s) with
/// s = n_a n_b / (n (n - 1)) d^T T^-1 d in [0, 1]: a permutation costs a sum over one group and no inverse.
///
/// Where the point moves in a plane, on a line or not at all, up to rounding, T^2 is that of so many dimensions, and
/// without any it is 0. Where the groups do not vary along their difference T^2 has no bound; 1e11 (n - 2) stands for
/// what is more. Statistics that differ by rounding count as equal.
///
/// \param is_b for each set whether it is in group B, at least two sets in each group, and dimension + 2 in both
/// \param n_permutations at most, the observed one among them, at least 1: all distinct ones where there are not more,
/// at random otherwise \param seed of these \throws InputError for groups that are too small, and as check_point_sets()
GroupDifference group_difference(const PointSets& aligned, const Eigen::VectorXd& weights,
                                 const std::vector<char>& is_b, int n_permutations, std::uint64_t seed);

/// The least rate of false discoveries at which each of the tests counts as one: with p in ascending order, the least
/// of m p_(j) / j over j >= i (Benjamini and Hochberg 1995).
Eigen::VectorXd false_discovery_rates(const Eigen::VectorXd& p);

}  // namespace shellmatch
