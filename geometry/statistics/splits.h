#pragma once
/// \file
/// Splits of shapes into two groups of given sizes, for permutation tests.

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace shellmatch {

/// The observed split and others.
class Splits {
 public:
  /// \param is_b the observed split
  /// \param limit at least 1: all distinct splits where there are not more; else the observed one, which is the first,
  /// and limit - 1 random ones, which may repeat
  Splits(const std::vector<char>& is_b, int limit, std::uint64_t seed);

  Eigen::Index size() const { return size_; }
  bool are_all() const { return are_all_; }
  /// Rows: shapes; a column for each of the splits from `begin` on: 1 in group B, 0 in group A.
  Eigen::MatrixXd indicators(Eigen::Index begin, Eigen::Index n) const;

 private:
  Eigen::Index n_shapes_, size_ = 0;
  bool are_all_ = false;
  std::vector<char> in_b_;  // split after split
};

}  // namespace shellmatch
