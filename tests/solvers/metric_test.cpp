// The metric is a change of variables: what it promises, and that every method reaches the same minimum in
// it.
#include "solvers/metric.h"

#include "base/error.h"
#include "tests/support/test_problems.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

TEST(Metric, GradientNormIsThatOfTheL2Gradient) {
  const auto problem = testing::weighted_bowl(12);
  const auto factor = make_metric_factor(Metric::l2, *problem);
  ASSERT_NE(factor, nullptr);
  MetricObjective in_metric(*problem, *factor);
  std::vector<double> x(12), y(12), gx(12), gy(12);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = 0.1 * static_cast<double>(i);
  factor->apply(x, y);
  double fx = 0, fy = 0;
  ASSERT_TRUE(problem->evaluate(x, fx, gx));
  ASSERT_TRUE(in_metric.evaluate(y, fy, gy));
  EXPECT_NEAR(fx, fy, 1e-14 * fx);
  // L2 gradient r = D^-1 g, and its L2 norm r.D r
  double expected = 0, actual = 0;
  const auto mass = problem->lumped_mass();
  for (std::size_t i = 0; i < x.size(); ++i) {
    expected += gx[i] * gx[i] / mass[i];
    actual += gy[i] * gy[i];
  }
  EXPECT_NEAR(actual, expected, 1e-13 * expected);
}

TEST(Metric, SteepestDescentFollowsTheL2Gradient) {
  // In y the bowl's second derivative is (1 + 3 e^2) for every unknown, whatever its mass: from a start that
  // is equally far everywhere, coordinates of equal error stay equal under any mass. In the Euclidean metric
  // not.
  struct Equal final : Objective {
    std::vector<double> mass{1, 1e-3, 1e-6};
    std::size_t size() const override { return 3; }
    bool evaluate(std::span<const double> x, double& value, std::span<double> g) override {
      value = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        value += mass[i] * (x[i] * x[i] / 2 + std::pow(x[i], 4) / 4);
        if (!g.empty()) g[i] = mass[i] * (x[i] + std::pow(x[i], 3));
      }
      return true;
    }
    std::span<const double> lumped_mass() const override { return mass; }
  } equal;
  const auto run = [&](Metric metric) {
    SolverOptions options;
    options.stop = {.max_iterations = 3,
                    .relative_decrease = 0,
                    .decrease_window = 10,
                    .gradient_norm = 0,
                    .max_seconds = 0};
    std::vector<double> x(3, 1.0);
    minimize_in_metric(*make_minimizer(options), metric, equal, x, options.stop);
    return x;
  };
  const auto l2 = run(Metric::l2), euclidean = run(Metric::euclidean);
  EXPECT_LT(l2[0], 0.999);
  EXPECT_NEAR(l2[0], l2[2], 1e-12);
  EXPECT_GT(euclidean[2], 0.9999);
}

TEST(Metric, ComesBackBitByBitWhereNothingWasGained) {
  const auto problem = testing::weighted_bowl(12);
  std::vector<double> x(12);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = 0.37 + 0.1 * static_cast<double>(i);
  const std::vector<double> before = x;
  const StopOptions stop{.max_iterations = 0};
  minimize_in_metric(*make_minimizer({}), Metric::l2, *problem, x, stop);
  EXPECT_EQ(x, before);
}

TEST(Metric, StepAndGradientOfTheRecordAreThoseOfTheMetric) {
  const auto problem = testing::weighted_bowl(12);
  std::vector<double> x = problem->start();
  const std::vector<double> before = x;
  const auto mass = problem->lumped_mass();
  IterationRecord last;
  const StopOptions stop{.max_iterations = 1};
  minimize_in_metric(*make_minimizer({}), Metric::l2, *problem, x, stop, [&](const IterationRecord& r) {
    last = r;
    return true;
  });
  double squared = 0;
  for (std::size_t i = 0; i < x.size(); ++i) squared += mass[i] * (x[i] - before[i]) * (x[i] - before[i]);
  EXPECT_NEAR(last.step, std::sqrt(squared), 1e-12 * last.step);
}

TEST(Metric, RefusesAMassThatIsNotPositive) {
  const std::vector<double> bad{1, 0, 1};
  EXPECT_THROW(DiagonalFactor{bad}, InputError);
  const std::vector<double> nan{1, std::nan(""), 1};
  EXPECT_THROW(DiagonalFactor{nan}, InputError);
}

class InEveryMetric : public ::testing::TestWithParam<std::string> {};

TEST_P(InEveryMetric, TheSameMinimumIsReached) {
  for (const Metric metric : {Metric::euclidean, Metric::l2}) {
    SolverOptions options;
    options.name = GetParam();
    options.metric = metric;
    options.stop = {.max_iterations = 20000,
                    .relative_decrease = 0,
                    .decrease_window = 10,
                    .gradient_norm = 1e-8,
                    .max_seconds = 20};
    const auto problem = testing::weighted_bowl(18);
    std::vector<double> x = problem->start();
    const auto summary = minimize_in_metric(*make_minimizer(options), metric, *problem, x, options.stop);
    // The lightest unknowns weigh 8^-5: without the mass their coordinates are known less well.
    EXPECT_EQ(problem->check(summary.final_value, x, 1e-10), "")
        << options.name << ", " << enum_name(metric) << ": " << summary.message << ", " << summary.iterations;
  }
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Methods, InEveryMetric, ::testing::ValuesIn(testing::first_order_minimizers()),
                         test_name);

}  // namespace
}  // namespace shellmatch
