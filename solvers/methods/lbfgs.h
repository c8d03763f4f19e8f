#pragma once
/// \file
/// Limited-memory BFGS, a robust first-order method for large problems.

#include "solvers/solver_options.h"

#include <cstddef>
#include <span>
#include <vector>

namespace shellmatch {

/// The limited-memory BFGS matrix H of Nocedal & Wright (7.19) with the scaling (7.20): symmetric, positive
/// definite, and H y = s for the last step s and its change of gradient y. The constructor allocates all
/// memory.
class LimitedMemoryInverseHessian {
 public:
  /// For n unknowns and up to `memory` >= 1 pairs. A pair is stored only if s.y > least_cosine |s||y|, so
  /// that H remains positive definite.
  LimitedMemoryInverseHessian(std::size_t n, std::size_t memory, double least_cosine);

  bool empty() const { return count_ == 0; }
  std::size_t count() const { return count_; }
  void clear() { count_ = 0; }

  /// Adds the pair of the step x0 -> x1 with gradients g0 -> g1, and returns whether its curvature suffices.
  /// If it does not and the memory was full, the oldest pair is lost, because its memory has been
  /// overwritten.
  bool add(std::span<const double> x0, std::span<const double> x1, std::span<const double> g0,
           std::span<const double> g1);

  /// d = -H g by the two-loop recursion, algorithm 7.4: one sweep over the unknowns for each stored vector.
  /// Without pairs H is the identity.
  void descend(std::span<const double> g, std::span<double> d);

 private:
  struct Pair {
    std::vector<double> s, y;
    double rho = 0;  // 1 / s.y
  };
  const Pair& newest(std::size_t age) const { return pairs_[(next_ + 2 * pairs_.size() - 1 - age) % pairs_.size()]; }

  double least_cosine_;
  std::vector<Pair> pairs_;  // a ring buffer; next_ is the position of the next pair
  std::vector<double> alpha_;
  double gamma_ = 1;
  std::size_t next_ = 0, count_ = 0;
};

/// Algorithm 7.5 of Nocedal & Wright: the two-loop recursion 7.4 with the scaling (7.20) and a line search by
/// the weak Wolfe conditions. These make s.y positive, and the unit step is nearly always accepted, so a step
/// costs little more than one evaluation with gradient.
///
/// A trial that cannot be evaluated contracts the step. Pairs without positive curvature (s.y <= least_cosine
/// |s||y|) are not stored. Where the direction is not a descent direction or its line search fails, the
/// memory is cleared and the steepest descent is tried; if that fails too, the method stops with
/// StopReason::no_descent. Uses 2 `memory` + 5 vectors, allocated before the loop.
class Lbfgs final : public Minimizer {
 public:
  explicit Lbfgs(const LbfgsOptions& options = {}) : options_(options) {}
  std::string name() const override { return "lbfgs"; }
  MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                            const IterationCallback& callback = {}) const override;

 private:
  LbfgsOptions options_;
};

}  // namespace shellmatch
