#pragma once
/// \file
/// Newton's method with an inexact linear solver, for objectives that offer a model of their second derivative.

#include "solvers/minimizer.h"
#include "solvers/solver_options.h"

namespace shellmatch {

/// Line search Newton with conjugate gradients: Nocedal & Wright, Numerical Optimization, algorithm 7.1. The
/// objective's model of the second derivative is positive semidefinite, so that directions are descent
/// directions; the linear system is solved the better, the more the last step has lowered the gradient (S. C.
/// Eisenstat and H. F. Walker, SIAM J. Sci. Comput. 17(1), 1996, choice 2, between min_forcing and max_forcing),
/// and to the root of the relative gradient norm where that is smaller, measured in the preconditioner's norm. A step
/// that leads beyond the model is computed again with damping there (solvers/methods/step_regularisation.h), by further
/// iterations from where it was. When a line search fails, the preconditioned gradient is tried once.
///
/// The objective must be a SecondOrderObjective; others end with StopReason::library and a message.
class Newton final : public Minimizer {
 public:
  explicit Newton(const NewtonOptions& options) : options_(options) {}
  std::string name() const override { return "newton"; }
  bool uses_metric() const override { return false; }
  MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                            const IterationCallback& callback = {}) const override;

 private:
  NewtonOptions options_;
};

}  // namespace shellmatch
