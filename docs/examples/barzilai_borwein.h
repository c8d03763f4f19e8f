#pragma once
/// \file
/// A method that is not in the program: the example of docs/adding-a-solver.md.

#include "solvers/minimization_run.h"
#include "solvers/vector_ops.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace example {

using namespace shellmatch;

/// Steps along the gradient of the length s.s / s.y (Barzilai and Borwein, IMA J. Numer. Anal. 8, 1988), halved until
/// the value falls.
class BarzilaiBorwein final : public Minimizer {
 public:
  std::string name() const override { return "barzilai_borwein"; }

  MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                            const IterationCallback& callback = {}) const override {
    MinimizationRun run(objective, stop, callback);
    std::vector<double> g(run.size()), trial(run.size()), trial_g(run.size()), s(run.size()), y(run.size());
    if (!run.start(x, g)) return run.summary();  // cannot be evaluated, zero gradient, no unknowns

    double value = run.start_value(), length = 0.01 / run.start_gradient_norm();
    while (!run.over()) {
      Evaluation at;
      for (int halvings = 0; halvings < 40 && !run.out_of_time(); ++halvings, length /= 2) {
        add_scaled(x, -length, g, trial);
        at = run.evaluate(trial, trial_g);  // not feasible: a fold, or anything not finite
        if (at.feasible && at.value < value) break;
      }
      if (!(at.feasible && at.value < value)) {
        run.finish(StopReason::no_descent);
        break;
      }
      const PairProducts pair = difference_pair(x, trial, g, trial_g, s, y);
      std::swap(x, trial);
      std::swap(g, trial_g);
      value = at.value;
      run.accept(at, std::sqrt(pair.s_s));
      if (pair.s_y > 0) length = pair.s_s / pair.s_y;
    }
    return run.summary();
  }
};

}  // namespace example
