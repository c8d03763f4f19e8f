// The example of docs/adding-a-solver.md: gradient steps of Barzilai and Borwein's length.
#include "solvers/metric/metric.h"
#include "solvers/minimization_run.h"
#include "solvers/vector_ops.h"
#include "tests/support/test_problems.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace shellmatch {
namespace {

/// Steps along the gradient of the length s.s / s.y (Barzilai and Borwein, IMA J. Numer. Anal. 8, 1988), halved until
/// the value falls.
class BarzilaiBorwein final : public Minimizer {
 public:
  std::string name() const override { return "barzilai_borwein"; }

  MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                            const IterationCallback& callback = {}) const override {
    MinimizationRun run(objective, stop, callback);
    const std::size_t n = run.size();
    std::vector<double> g(n), trial(n), trial_g(n), s(n), y(n);
    if (!run.start(x, g)) return run.summary();  // cannot be evaluated, zero gradient, no unknowns

    double value = run.start_value(), norm_g = run.start_gradient_norm(), length = 0.01 / norm_g;
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

TEST(Example, SolvesPublishedProblemsInTheirMetric) {
  const StopOptions stop{.max_iterations = 20000, .relative_decrease = 0, .gradient_norm = 1e-8};
  for (const auto& problem : {testing::log_barrier(10, 0.1), testing::weighted_bowl(18)}) {
    std::vector<double> x = problem->start();
    int records = 0;
    const auto summary =
        minimize_in_metric(BarzilaiBorwein(), Metric::l2, *problem, x, stop, [&](const IterationRecord&) {
          ++records;
          return true;
        });
    EXPECT_EQ(problem->check(summary.final_value, x, 1e-8), "") << summary.message;
    EXPECT_EQ(summary.reason, StopReason::gradient_norm);
    EXPECT_EQ(records, summary.iterations + 1);
  }
}

TEST(Example, SaysWhyItStops) {
  const auto problem = testing::extended_rosenbrock(4);
  std::vector<double> x = problem->start();
  const StopOptions stop{.max_iterations = 3};
  EXPECT_EQ(BarzilaiBorwein().minimize(*problem, x, stop).reason, StopReason::max_iterations);
  std::vector<double> at_minimum(4, 1.0), nowhere(4, std::nan(""));
  EXPECT_EQ(BarzilaiBorwein().minimize(*problem, at_minimum, stop).reason, StopReason::gradient_norm);
  EXPECT_EQ(BarzilaiBorwein().minimize(*problem, nowhere, stop).reason, StopReason::cannot_evaluate_start);
}

}  // namespace
}  // namespace shellmatch
