#pragma once
/// \file
/// The paper's method: nonlinear conjugate gradients after Fletcher and Reeves.

#include "solvers/solver_options.h"

namespace shellmatch {

/// Algorithm 5.4 of Nocedal & Wright with the backtracking line search of their section 3.1, both as in the
/// paper. Directions d_k = -g_k + beta_k d_{k-1}, beta_k = |g_k|^2 / |g_{k-1}|^2.
///
/// The method restarts with the steepest descent where d_k is not a descent direction or its line search
/// fails, after `restart_every` iterations, and where successive gradients are far from orthogonal. It stops
/// with StopReason::no_descent where the line search along the steepest descent finds no lower value.
///
/// Uses five vectors, allocated before the loop. One gradient is accepted per step, and the first trial is
/// usually accepted (LineSearchOptions::gradient_trials explains why trials are evaluated with their
/// gradient).
class FletcherReeves final : public Minimizer {
 public:
  explicit FletcherReeves(const FletcherReevesOptions& options = {}) : options_(options) {}
  std::string name() const override { return "fletcher_reeves"; }
  MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                            const IterationCallback& callback = {}) const override;

 private:
  FletcherReevesOptions options_;
};

}  // namespace shellmatch
