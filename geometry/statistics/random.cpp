#include "geometry/statistics/random.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// Whether there are at most `limit` subsets of k of n.
bool are_few(std::size_t n, std::size_t k, int limit) {
  double count = 1;  // exact below 2^53, and far above any limit where it is not
  for (std::size_t i = 1; i <= std::min(k, n - k); ++i) {
    count = count * static_cast<double>(n - i + 1) / static_cast<double>(i);
    if (count > limit) return false;
  }
  return true;
}

}  // namespace

Splits::Splits(const std::vector<char>& is_b, int limit, std::uint64_t seed)
    : n_shapes_(static_cast<Eigen::Index>(is_b.size())) {
  std::vector<char> split;
  for (const char b : is_b) split.push_back(b != 0 ? 1 : 0);
  const auto add = [&] {
    in_b_.insert(in_b_.end(), split.begin(), split.end());
    ++size_;
  };
  are_all_ = are_few(split.size(), static_cast<std::size_t>(std::count(split.begin(), split.end(), 1)), limit);
  if (are_all_) {
    std::sort(split.begin(), split.end());
    do add();
    while (std::next_permutation(split.begin(), split.end()));
    return;
  }
  Random random(seed);
  in_b_.reserve(split.size() * static_cast<std::size_t>(limit));
  for (add(); size_ < limit; add()) random.shuffle(split);
}

Eigen::MatrixXd Splits::indicators(Eigen::Index begin, Eigen::Index n) const {
  return Eigen::Map<const Eigen::Matrix<char, Eigen::Dynamic, Eigen::Dynamic>>(in_b_.data() + begin * n_shapes_,
                                                                               n_shapes_, n)
      .cast<double>();
}

double Random::normal() {
  if (has_second_) {
    has_second_ = false;
    return second_;
  }
  double u, v, square;
  do {
    u = 2 * uniform() - 1;
    v = 2 * uniform() - 1;
    square = u * u + v * v;
  } while (square >= 1 || square == 0);
  const double factor = std::sqrt(-2 * std::log(square) / square);
  second_ = v * factor;
  has_second_ = true;
  return u * factor;
}

std::uint64_t Random::below(std::uint64_t n) {
  // Of the 2^64 values, the first 2^64 mod n would make small remainders more frequent.
  const std::uint64_t first = (0 - n) % n;
  std::uint64_t value;
  do value = bits_();
  while (value < first);
  return value % n;
}

}  // namespace shellmatch
