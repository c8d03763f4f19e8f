#pragma once
/// \file
/// Random numbers that are the same everywhere, as the standard fixes the output of std::mt19937_64 but not that of its
/// distributions, and random splits of shapes into two groups.

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
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

/// Numbers that follow from a seed.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  /// Of mean 0 and variance 1. G. Marsaglia and T. A. Bray, SIAM Rev. 6(3), 1964: the polar method. Last digits depend
  /// on the machine's logarithm.
  double normal();
  /// A whole number below n, each with the same probability. \pre n > 0
  std::uint64_t below(std::uint64_t n);
  /// Every order with the same probability. R. Durstenfeld, Comm. ACM 7(7), 1964, algorithm 235.
  template <class T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::mt19937_64 bits_;
  double second_ = 0;  // of the pair that the polar method makes
  bool has_second_ = false;
};

}  // namespace shellmatch
