// The example of docs/adding-a-solver.md: gradient steps of Barzilai and Borwein's length.
#include "docs/examples/barzilai_borwein.h"
#include "solvers/metric/metric.h"
#include "tests/support/test_problems.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace shellmatch {
namespace {

using example::BarzilaiBorwein;

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
