#include "solvers/methods/inverse_hessian.h"

#include "solvers/vector_ops.h"

#include <cmath>

namespace shellmatch {

LimitedMemoryInverseHessian::LimitedMemoryInverseHessian(std::size_t n, std::size_t memory, double least_cosine)
    : least_cosine_(least_cosine), pairs_(memory), alpha_(memory) {
  for (Pair& p : pairs_) {
    p.s.resize(n);
    p.y.resize(n);
  }
}

bool LimitedMemoryInverseHessian::add(std::span<const double> x0, std::span<const double> x1,
                                      std::span<const double> g0, std::span<const double> g1) {
  Pair& p = pairs_[next_];
  const PairProducts products = difference_pair(x0, x1, g0, g1, p.s, p.y);
  if (!(products.s_y > least_cosine_ * std::sqrt(products.s_s) * std::sqrt(products.y_y))) {
    if (count_ == pairs_.size()) --count_;
    return false;
  }
  p.rho = 1 / products.s_y;
  gamma_ = products.s_y / products.y_y;
  next_ = (next_ + 1) % pairs_.size();
  if (count_ < pairs_.size()) ++count_;
  return true;
}

void LimitedMemoryInverseHessian::descend(std::span<const double> g, std::span<double> d) {
  conjugate_direction(g, 0, d);
  if (count_ == 0) return;
  // Every sweep updates d and computes its product with the vector of the next sweep.
  double product = dot(d, newest(0).s);
  for (std::size_t i = 0; i < count_; ++i) {
    const Pair& p = newest(i);
    alpha_[i] = p.rho * product;
    product = add_scaled_and_dot(-alpha_[i], p.y, d, i + 1 < count_ ? newest(i + 1).s : p.y);
  }
  scale(gamma_, d);
  product *= gamma_;  // d.y of the oldest pair
  for (std::size_t i = count_; i-- > 0;) {
    const Pair& p = newest(i);
    product = add_scaled_and_dot(alpha_[i] - p.rho * product, p.s, d, i > 0 ? newest(i - 1).y : p.s);
  }
}

}  // namespace shellmatch
