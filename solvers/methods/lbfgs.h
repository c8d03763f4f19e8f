#pragma once
/// \file
/// Limited-memory BFGS, a robust first-order method for large problems.

#include "solvers/options.h"

namespace shellmatch {

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
