// Starts that cannot be evaluated, empty problems, callers that stop, clocks, exceptions, threads.
#include "base/parallel.h"
#include "solvers/libraries/nlopt_minimizer.h"
#include "solvers/metric/metric.h"
#include "solvers/solver_options.h"
#include "tests/support/test_problems.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

namespace shellmatch {
namespace {

const StopOptions long_run{
    .max_iterations = 100000, .relative_decrease = 0, .decrease_window = 10, .gradient_norm = 1e-12, .max_seconds = 20};

class AnyMinimizer : public ::testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Minimizer> minimizer() const {
    SolverOptions options;
    options.name = GetParam();
    options.ceres = testing::without_tolerances();
    return make_minimizer(options);
  }
};

TEST_P(AnyMinimizer, SaysThatTheStartCannotBeEvaluated) {
  const auto problem = testing::extended_rosenbrock(4);
  std::vector<double> x(4, std::numeric_limits<double>::quiet_NaN());
  int calls = 0;
  const auto summary =
      minimizer()->minimize(*problem, x, long_run, [&](const IterationRecord&) { return ++calls > 0; });
  EXPECT_EQ(summary.reason, StopReason::cannot_evaluate_start);
  EXPECT_EQ(summary.iterations, 0);
  EXPECT_EQ(calls, 0);

  const auto barrier = testing::log_barrier(3, 1);
  std::vector<double> outside(3, -1.0);
  EXPECT_EQ(minimizer()->minimize(*barrier, outside, long_run).reason, StopReason::cannot_evaluate_start);
  EXPECT_EQ(outside, std::vector<double>(3, -1.0));
}

// A bowl that is finite at its start alone, or whose gradient is.
struct FiniteAtItsStart final : testing::UnitModel {
  bool only_gradient = false;
  std::size_t size() const override { return 2; }
  static bool is_start(std::span<const double> x) { return x[0] == 1 && x[1] == 1; }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    value = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      value += 0.5 * x[i] * x[i];
      if (!gradient.empty()) gradient[i] = is_start(x) ? x[i] : nan;
    }
    if (!only_gradient && !is_start(x)) value = nan;
    return true;
  }
  std::string what_is_not_finite(std::span<const double> x) override {
    return is_start(x) ? "" : "the term wall is not finite there";
  }
};

TEST(LineSearchMethods, SayWhatIsNotFiniteAlongTheLine) {
  for (const std::string name : {"newton", "lbfgs", "fletcher_reeves"})
    for (const bool only_gradient : {false, true}) {
      FiniteAtItsStart objective;
      objective.only_gradient = only_gradient;
      SolverOptions options;
      options.name = name;
      std::vector<double> x{1, 1};
      const auto summary = make_minimizer(options)->minimize(objective, x, long_run);
      EXPECT_EQ(summary.reason, StopReason::no_descent) << name;
      EXPECT_EQ(summary.message,
                "no lower value can be found along the steepest descent: the term wall is not finite there")
          << name;
      EXPECT_EQ(x, (std::vector<double>{1, 1})) << name;
    }
}

TEST_P(AnyMinimizer, StopsAtOnceWhereTheGradientIsZero) {
  const auto problem = testing::extended_rosenbrock(4);
  std::vector<double> x(4, 1.0);
  const auto summary = minimizer()->minimize(*problem, x, long_run);
  EXPECT_EQ(summary.reason, StopReason::gradient_norm);
  EXPECT_EQ(summary.iterations, 0);
  EXPECT_EQ(summary.value_evaluations, 1);
  EXPECT_EQ(x, std::vector<double>(4, 1.0));
}

TEST_P(AnyMinimizer, HasNothingToDoWithoutUnknowns) {
  const auto problem = testing::weighted_bowl(0);
  std::vector<double> x;
  const auto summary = minimizer()->minimize(*problem, x, long_run);
  EXPECT_EQ(summary.reason, StopReason::gradient_norm);
  EXPECT_EQ(summary.message, "there are no unknowns");
}

TEST_P(AnyMinimizer, StopsWhenTheCallerSaysSo) {
  const auto problem = testing::extended_rosenbrock(20);
  for (const int last : {0, 3}) {
    std::vector<double> x = problem->start();
    const auto summary =
        minimizer()->minimize(*problem, x, long_run, [&](const IterationRecord& r) { return r.iteration < last; });
    EXPECT_EQ(summary.reason, StopReason::interrupted);
    EXPECT_EQ(summary.iterations, last);
    double value = 0;
    ASSERT_TRUE(problem->evaluate(x, value, {}));
    EXPECT_EQ(value, summary.final_value);
    if (last == 0) {
      EXPECT_EQ(x, problem->start());
    }
  }
}

TEST_P(AnyMinimizer, LetsExceptionsOfCallerAndObjectiveThrough) {
  const auto problem = testing::extended_rosenbrock(20);
  std::vector<double> x = problem->start();
  EXPECT_THROW(minimizer()->minimize(*problem, x, long_run,
                                     [](const IterationRecord& r) -> bool {
                                       if (r.iteration == 2) throw std::runtime_error("caller");
                                       return true;
                                     }),
               std::runtime_error);
  struct Throwing final : testing::UnitModel {
    int calls = 0;
    std::size_t size() const override { return 2; }
    bool evaluate(std::span<const double> y, double& value, std::span<double> gradient) override {
      if (++calls == 3) throw std::length_error("objective");
      value = y[0] * y[0] + 100 * y[1] * y[1];
      if (!gradient.empty()) {
        gradient[0] = 2 * y[0];
        gradient[1] = 200 * y[1];
      }
      return true;
    }
  } throwing;
  std::vector<double> y{1.3, 0.7};
  EXPECT_THROW(minimizer()->minimize(throwing, y, long_run), std::length_error);
}

TEST_P(AnyMinimizer, KeepsTheTimeLimit) {
  struct Slow final : testing::UnitModel {
    std::unique_ptr<testing::TestProblem> inner = testing::extended_rosenbrock(20);
    std::size_t size() const override { return inner->size(); }
    bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      return inner->evaluate(x, value, gradient);
    }
  } slow;
  StopOptions stop = long_run;
  stop.max_seconds = 0.05;
  std::vector<double> x = slow.inner->start();
  const auto summary = minimizer()->minimize(slow, x, stop);
  EXPECT_EQ(summary.reason, StopReason::max_seconds) << summary.message;
  EXPECT_GE(summary.seconds, 0.05);
  EXPECT_LE(summary.value_evaluations, 11);
  EXPECT_LE(summary.final_value, summary.initial_value);
}

// An objective that does not say so itself: NaN or infinity with the word that all is well.
TEST_P(AnyMinimizer, TakesWhatIsNotFiniteForAPlaceThatCannotBeEvaluated) {
  struct Careless final : testing::UnitModel {
    std::size_t size() const override { return 2; }
    bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
      value = x[0] - std::log(x[0]) + x[1] - std::log(x[1]);
      for (std::size_t i = 0; i < gradient.size(); ++i)
        gradient[i] = x[i] > 0 && x[i] < 0.2 ? std::numeric_limits<double>::infinity() : 1 - 1 / x[i];
      return true;
    }
  } careless;
  StopOptions stop = long_run;
  stop.max_iterations = 5000;
  std::vector<double> x{8, 0.3};
  const auto summary = minimizer()->minimize(careless, x, stop);
  EXPECT_NEAR(summary.final_value, 2, 1e-8) << summary.message;
  for (const double start : {-1.0, 0.1}) {  // the value is NaN, the gradient is infinite
    std::vector<double> outside{start, start};
    EXPECT_EQ(minimizer()->minimize(careless, outside, stop).reason, StopReason::cannot_evaluate_start) << start;
  }
}

// A gradient that does not belong to the value: no step goes down. Nothing may be reported that is not lower.
TEST_P(AnyMinimizer, EndsWhereTheGradientPointsTheWrongWay) {
  struct Wrong final : testing::UnitModel {
    std::size_t size() const override { return 3; }
    bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
      value = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        value += x[i] * x[i];
        if (!gradient.empty()) gradient[i] = -2 * x[i];
      }
      return true;
    }
  } wrong;
  std::vector<double> x{1, 2, 3};
  StopOptions stop = long_run;
  stop.max_iterations = 1000;
  const auto summary = minimizer()->minimize(wrong, x, stop);
  EXPECT_LE(summary.final_value, summary.initial_value);
  EXPECT_FALSE(summary.message.empty());
  EXPECT_LT(summary.value_evaluations, 20000);
  if (GetParam() == "fletcher_reeves" || GetParam() == "lbfgs" || GetParam() == "newton") {
    EXPECT_EQ(summary.reason, StopReason::no_descent);
    EXPECT_EQ(x, (std::vector<double>{1, 2, 3}));
  }
}

TEST_P(AnyMinimizer, GivesTheSameBitsWithOneThreadAndTwo) {
  // Long enough for several pieces of the vector operations; the dense method gets what it can take.
  const bool dense = GetParam() == "ceres_bfgs";
  const auto problem = testing::extended_rosenbrock(dense ? 100 : 40000);
  StopOptions stop = long_run;
  stop.max_iterations = 12;
  std::vector<double> points[2];
  for (int threads : {1, 2}) {
    set_n_threads(threads);
    auto& x = points[threads - 1];
    x = problem->start();
    minimizer()->minimize(*problem, x, stop);
  }
  set_n_threads(0);
  EXPECT_EQ(points[0], points[1]);
}

std::string name_of_method(const ::testing::TestParamInfo<std::string>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Methods, AnyMinimizer, ::testing::ValuesIn(minimizer_names()), name_of_method);

// At most 1.6 evaluations and one gradient per step is what the step memory is for.
TEST(Economy, OurMethodsEvaluateLittleMoreThanOncePerStep) {
  for (const std::string name : {"fletcher_reeves", "lbfgs"}) {
    SolverOptions options;
    options.name = name;
    const auto problem = testing::extended_rosenbrock(2000);
    StopOptions stop = long_run;
    stop.max_iterations = 200;
    std::vector<double> x = problem->start();
    const auto s = make_minimizer(options)->minimize(*problem, x, stop);
    EXPECT_LT(static_cast<double>(s.value_evaluations), 1.6 * s.iterations + 1) << name;
  }
}

// After a stall the library begins anew at the best point, with a whole allowance of evaluations that gain nothing.
TEST(Nlopt, EvaluatesAgainAfterAStall) {
  const auto run = [](int max_restarts) {
    const auto problem = testing::extended_rosenbrock(20);
    std::vector<double> x = problem->start();
    return NloptMinimizer(NloptMethod::mma, 10, max_restarts)
        .minimize(*problem, x, {.max_iterations = 100000, .relative_decrease = 0, .gradient_norm = 0});
  };
  const MinimizerSummary first = run(0), second = run(1);
  EXPECT_EQ(first.message, "NLopt: no lower value in max_stalled_evaluations evaluations (0 restarts)");
  EXPECT_LE(second.final_value, first.final_value);
  EXPECT_GE(second.value_evaluations, first.value_evaluations + 5);
}

}  // namespace
}  // namespace shellmatch
