#include "solvers/line_search/line_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace shellmatch {
namespace {

// A function of one unknown that cannot be evaluated beyond `edge`.
struct OneDimensional final : Objective {
  std::function<double(double)> f, derivative;
  double edge = 1e300;
  std::size_t size() const override { return 1; }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    if (x[0] >= edge) return false;
    value = f(x[0]);
    if (!gradient.empty()) gradient[0] = derivative(x[0]);
    return true;
  }
};

struct Searched {
  LineSearchResult result;
  double x = 0, gradient = 0;
  long values = 0, gradients = 0;
};

Searched search(OneDimensional& f, double first_alpha, const LineSearchOptions& options) {
  const StopOptions stop;
  const IterationCallback none;
  MinimizationRun run(f, stop, none);
  Line line(run);
  const std::vector<double> base{0}, direction{1};
  line.lay(base, direction, f.f(0), f.derivative(0));
  Searched s;
  s.result = search_line(line, first_alpha, options);
  s.x = line.x[0];
  s.gradient = line.gradient[0];
  s.values = run.summary().value_evaluations;
  s.gradients = run.summary().gradient_evaluations;
  return s;
}

OneDimensional parabola() {
  OneDimensional f;
  f.f = [](double x) { return (x - 1) * (x - 1); };
  f.derivative = [](double x) { return 2 * (x - 1); };
  return f;
}

TEST(InterpolatedMinimum, IsExactForParabolasAndCubics) {
  const LinePoint a{
      .alpha = 0.5, .value = 0.25, .slope = -1, .gradient_norm = 1, .feasible = true, .has_gradient = true};
  const LinePoint b{.alpha = 3, .value = 4, .slope = 4, .gradient_norm = 1, .feasible = true, .has_gradient = false};
  EXPECT_NEAR(interpolated_minimum(a, b), 1, 1e-14);  // (x - 1)^2
  const auto cubic = [](double x) {
    return LinePoint{.alpha = x,
                     .value = x * x * x - 3 * x,
                     .slope = 3 * x * x - 3,
                     .gradient_norm = 1,
                     .feasible = true,
                     .has_gradient = true};
  };
  EXPECT_NEAR(interpolated_minimum(cubic(0), cubic(2)), 1, 1e-14);
  EXPECT_NEAR(interpolated_minimum(cubic(0.9), cubic(5)), 1, 1e-13);
}

TEST(SearchLine, AcceptsAGoodFirstTrialWithOneEvaluation) {
  auto f = parabola();
  const auto s = search(f, 0.9, {});
  EXPECT_TRUE(s.result.success);
  EXPECT_EQ(s.x, 0.9);
  EXPECT_EQ(s.values, 1);
  EXPECT_EQ(s.gradients, 1);
}

TEST(SearchLine, HalvesToTheLetter) {
  auto f = parabola();
  // 16 and 8, 4, 2.1 are above the Armijo line of (x - 1)^2, 16 / 2^4 = 1 is not.
  const auto s = search(f, 16, {.interpolation = Interpolation::halving});
  EXPECT_TRUE(s.result.success);
  EXPECT_DOUBLE_EQ(s.x, 1);
  EXPECT_EQ(s.result.n_trials, 5);
}

TEST(SearchLine, InterpolationFindsTheMinimumOfAParabolaAtTheSecondTrial) {
  for (const auto interpolation : {Interpolation::quadratic, Interpolation::cubic}) {
    auto f = parabola();
    const auto s = search(f, 4, {.interpolation = interpolation});
    EXPECT_TRUE(s.result.success);
    EXPECT_NEAR(s.x, 1, 1e-12);
    EXPECT_EQ(s.result.n_trials, 2);
  }
}

TEST(SearchLine, GradientBelongsToTheAcceptedPoint) {
  for (const int gradient_trials : {0, 1, 2, 40})
    for (const double first : {0.3, 3.0, 50.0, 1e5}) {
      auto f = parabola();
      const auto s = search(f, first, {.interpolation = Interpolation::halving, .gradient_trials = gradient_trials});
      ASSERT_TRUE(s.result.success);
      EXPECT_EQ(s.x, s.result.point.alpha);
      EXPECT_EQ(s.gradient, f.derivative(s.x));
      EXPECT_EQ(s.result.point.slope, s.gradient);
      if (gradient_trials == 0) {
        EXPECT_EQ(s.gradients, 1);
      }
    }
}

TEST(SearchLine, WeakWolfeConditionsHold) {
  // Steep, then flat, then a steep rise.
  OneDimensional f;
  f.f = [](double x) { return std::exp(-3 * x) + 1e-3 * std::exp(x); };
  f.derivative = [](double x) { return -3 * std::exp(-3 * x) + 1e-3 * std::exp(x); };
  for (const double c2 : {0.1, 0.5, 0.9})
    for (const double first : {1e-6, 1e-2, 1.0, 30.0, 1e4}) {
      const auto s = search(f, first, {.curvature = c2});
      ASSERT_TRUE(s.result.success) << c2 << ", " << first;
      EXPECT_LE(f.f(s.x), f.f(0) + 1e-4 * s.x * f.derivative(0)) << c2 << ", " << first;
      EXPECT_GE(f.derivative(s.x), c2 * f.derivative(0)) << c2 << ", " << first;
    }
}

TEST(SearchLine, ContractsWhereNothingCanBeEvaluated) {
  auto f = parabola();
  f.edge = 0.4;
  for (const double c2 : {0.0, 0.1}) {
    const auto s = search(f, 1000, {.curvature = c2});
    EXPECT_TRUE(s.result.success);
    EXPECT_GT(s.x, 0.15);
    EXPECT_LT(s.x, f.edge);
    EXPECT_EQ(s.gradient, f.derivative(s.x));
  }
}

TEST(SearchLine, FallsBackOnTheLowestPointWhenTheTrialsRunOut) {
  auto f = parabola();
  f.edge = 0.4;
  // 0.15 is too short for the curvature condition, the second trial lies beyond the edge.
  const auto s = search(f, 0.15, {.curvature = 0.1, .max_trials = 2});
  EXPECT_TRUE(s.result.success);
  EXPECT_EQ(s.result.n_trials, 2);
  EXPECT_EQ(s.x, 0.15);
  EXPECT_EQ(s.gradient, f.derivative(0.15));
}

TEST(SearchLine, FailsWhereNothingIsLower) {
  OneDimensional f;
  f.f = [](double x) { return x; };
  f.derivative = [](double) { return -1.0; };
  const auto s = search(f, 1, {});
  EXPECT_FALSE(s.result.success);
  EXPECT_LE(s.result.n_trials, 40);
}

}  // namespace
}  // namespace shellmatch
