#pragma once
/// \file
/// The inverse second derivative that the last steps of a minimisation imply.

#include <cstddef>
#include <span>
#include <vector>

namespace shellmatch {

/// The limited-memory BFGS matrix H of Nocedal & Wright (7.19) with the scaling (7.20): symmetric, positive
/// definite, and H y = s for the newest step s and its change of gradient y. All memory is allocated at once.
class LimitedMemoryInverseHessian {
 public:
  /// For n unknowns and up to `memory` >= 1 pairs. A pair is kept only if s.y > least_cosine |s||y|, so that
  /// H stays positive definite.
  LimitedMemoryInverseHessian(std::size_t n, std::size_t memory, double least_cosine);

  bool empty() const { return count_ == 0; }
  std::size_t count() const { return count_; }
  void clear() { count_ = 0; }

  /// Takes the step x0 -> x1 with gradients g0 -> g1, or refuses it for want of curvature: then where the
  /// memory was full the oldest pair is lost, whose place it was written to.
  bool add(std::span<const double> x0, std::span<const double> x1, std::span<const double> g0,
           std::span<const double> g1);

  /// d = -H g by the two-loop recursion, algorithm 7.4: one sweep over the unknowns for each vector of
  /// memory. Without any pair H is the identity.
  void descend(std::span<const double> g, std::span<double> d);

 private:
  struct Pair {
    std::vector<double> s, y;
    double rho = 0;  // 1 / s.y
  };
  const Pair& newest(std::size_t age) const {
    return pairs_[(next_ + 2 * pairs_.size() - 1 - age) % pairs_.size()];
  }

  double least_cosine_;
  std::vector<Pair> pairs_;  // a ring; next_ is where the next pair goes
  std::vector<double> alpha_;
  double gamma_ = 1;
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace shellmatch
