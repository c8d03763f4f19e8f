#pragma once
/// \file
/// The paper's method: nonlinear conjugate gradients after Fletcher and Reeves.

#include "solvers/options.h"

namespace shellmatch {

/// Algorithm 5.4 of Nocedal & Wright with the backtracking line search of their section 3.1 (the paper names
/// both). Directions d_k = -g_k + beta_k d_{k-1}, beta_k = |g_k|^2 / |g_{k-1}|^2.
///
/// It restarts with the steepest descent where d_k does not go down or its line search fails, after
/// `restart_every` iterations, and where successive gradients are far from orthogonal. It ends with
/// StopReason::no_descent where no lower value is found along the steepest descent.
///
/// Five vectors of memory, none of it allocated within the loop; every accepted step has exactly one accepted
/// gradient, and the first trial is chosen so well that few steps need a second (LineSearchOptions says why
/// trials come with their gradient).
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
