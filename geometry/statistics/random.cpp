#include "geometry/statistics/random.h"

#include <cmath>

namespace shellmatch {

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
