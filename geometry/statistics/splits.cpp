#include "geometry/statistics/splits.h"

#include "geometry/statistics/random.h"

#include <algorithm>

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

}  // namespace shellmatch
