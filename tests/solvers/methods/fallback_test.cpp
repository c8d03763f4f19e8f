// A method that gives up, and the one that goes on.
#include "solvers/methods/fallback.h"

#include "base/error.h"
#include "tests/support/test_problems.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

const StopOptions thorough{.max_iterations = 5000, .relative_decrease = 0, .gradient_norm = 1e-9};

/// Newton finds no second derivative here, and says so.
struct FirstOrderOnly final : Objective {
  std::unique_ptr<testing::TestProblem> inner = testing::extended_rosenbrock(20);
  std::size_t size() const override { return inner->size(); }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    return inner->evaluate(x, value, gradient);
  }
};

TEST(Fallback, NewtonGivesWayToLbfgsByDefaultAndSaysSo) {
  FirstOrderOnly problem;
  SolverOptions options;
  options.name = "newton";
  std::vector<double> x = problem.inner->start();
  std::vector<IterationRecord> records;
  std::vector<std::string> announced;
  const auto s = minimize_with_fallback(
      options, problem, x, thorough,
      [&](const IterationRecord& r) {
        records.push_back(r);
        return true;
      },
      [&](const std::string& text) { announced.push_back(text); });
  EXPECT_EQ(problem.inner->check(s.final_value, x, 1e-8), "");
  EXPECT_EQ(s.solver, "lbfgs");
  ASSERT_EQ(s.fallbacks.size(), 1u);
  EXPECT_EQ(announced, s.fallbacks);
  EXPECT_NE(s.fallbacks[0].find("newton gave up after 0 iterations (library: the objective has no second derivative"),
            std::string::npos)
      << s.fallbacks[0];
  EXPECT_NE(s.fallbacks[0].find("lbfgs goes on"), std::string::npos) << s.fallbacks[0];
  // One sequence of records: nothing is counted twice, the start stands there once.
  ASSERT_EQ(static_cast<int>(records.size()), s.iterations + 1);
  EXPECT_EQ(records[0].solver, "newton");
  for (std::size_t i = 1; i < records.size(); ++i) {
    EXPECT_EQ(records[i].iteration, static_cast<int>(i));
    EXPECT_EQ(records[i].solver, "lbfgs");
    EXPECT_LE(records[i].value, records[i - 1].value);
    EXPECT_GT(records[i].value_evaluations, records[i - 1].value_evaluations);
    EXPECT_GE(records[i].seconds, records[i - 1].seconds);
  }
  EXPECT_EQ(records.back().value_evaluations, s.value_evaluations);
}

// A wall that the objective does not announce: steps across it cannot be evaluated, until `holds` is used up.
struct Wall final : Objective {
  int holds = 60;
  std::size_t size() const override { return 2; }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    value = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      value += (x[i] - 3) * (x[i] - 3);
      if (!gradient.empty()) gradient[i] = 2 * (x[i] - 3);
    }
    return (x[0] == 0 && x[1] == 0) || --holds < 0;
  }
};

TEST(Fallback, TakesTheMethodsInTheirOrderFromTheBestPoint) {
  SolverOptions options;
  options.name = "fletcher_reeves";
  options.fletcher_reeves.max_trials = 20;
  options.lbfgs.max_trials = 20;
  options.fallback = {"lbfgs", "nlopt_var2"};
  Wall wall;
  wall.holds = 45;  // twenty trials of each of the first two, and a few more
  std::vector<double> x{0, 0};
  const auto s = minimize_with_fallback(options, wall, x, thorough);
  ASSERT_EQ(s.fallbacks.size(), 2u);
  EXPECT_NE(s.fallbacks[0].find("fletcher_reeves gave up"), std::string::npos);
  EXPECT_NE(s.fallbacks[1].find("lbfgs gave up"), std::string::npos);
  EXPECT_EQ(s.solver, "nlopt_var2");
  EXPECT_NEAR(x[0], 3, 1e-6);
}

TEST(Fallback, IsNotTakenWhereNobodyAskedForIt) {
  FirstOrderOnly problem;
  SolverOptions options;
  options.name = "newton";
  options.fallback = {};
  std::vector<double> x = problem.inner->start();
  auto s = minimize_with_fallback(options, problem, x, thorough);
  EXPECT_EQ(s.reason, StopReason::library);
  EXPECT_TRUE(s.fallbacks.empty());
  EXPECT_EQ(x, problem.inner->start());
  // auto is for newton alone: a comparison of methods must not run another one unasked.
  options.name = "lbfgs";
  options.fallback = {"auto"};
  EXPECT_TRUE(fallback_names(options).empty());
}

TEST(Fallback, IsNotTakenFromAMethodThatHasConverged) {
  const auto problem = testing::extended_rosenbrock(20);
  SolverOptions options;
  options.name = "nlopt_lbfgs";  // ends by its own rules, for rounding
  options.fallback = {"lbfgs"};
  StopOptions stop = thorough;
  stop.gradient_norm = 0;
  std::vector<double> x = problem->start();
  const auto s = minimize_with_fallback(options, *problem, x, stop);
  EXPECT_TRUE(s.fallbacks.empty()) << s.fallbacks[0];
  EXPECT_EQ(s.solver, "nlopt_lbfgs");
}

TEST(Fallback, KeepsWithinTheLimits) {
  FirstOrderOnly problem;
  SolverOptions options;
  options.name = "newton";
  options.fallback = {"fletcher_reeves"};
  StopOptions stop = thorough;
  stop.max_iterations = 3;
  std::vector<double> x = problem.inner->start();
  const auto s = minimize_with_fallback(options, problem, x, stop);
  EXPECT_EQ(s.iterations, 3);
  EXPECT_EQ(s.reason, StopReason::max_iterations);
}

TEST(Fallback, NamesTheLimitAsItWasGivenAndNotWhatWasLeftOfIt) {
  SolverOptions options;
  options.name = "fletcher_reeves";
  options.fletcher_reeves.max_trials = 20;
  options.fallback = {"lbfgs"};
  options.lbfgs.max_trials = 20;
  // The first method takes steps, meets a wall in all directions and gives up; then the wall falls.
  struct LateWall final : Objective {
    std::unique_ptr<testing::TestProblem> inner = testing::extended_rosenbrock(20);
    int n_before = 20, n_blocked = 40;
    std::vector<double> last;  // the last point that could be evaluated
    std::size_t size() const override { return inner->size(); }
    bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
      const bool is_free =
          --n_before > 0 || std::equal(x.begin(), x.end(), last.begin(), last.end()) || --n_blocked < 0;
      if (is_free) last.assign(x.begin(), x.end());
      return inner->evaluate(x, value, gradient) && is_free;
    }
  } problem;
  StopOptions stop = thorough;
  stop.max_iterations = 30;
  std::vector<double> x = problem.inner->start();
  const auto s = minimize_with_fallback(options, problem, x, stop);
  ASSERT_EQ(s.fallbacks.size(), 1u);
  ASSERT_EQ(s.fallbacks[0].find("after 0 iterations"), std::string::npos) << s.fallbacks[0];
  ASSERT_EQ(s.reason, StopReason::max_iterations) << s.message;
  EXPECT_EQ(s.iterations, 30);
  EXPECT_EQ(s.message, "30 iterations are done");
}

/// No first-order method is done with it in fifty steps.
struct SlowBowl final : Objective {
  std::size_t size() const override { return 400; }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    value = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double curvature = std::pow(10, 6.0 * static_cast<double>(i) / static_cast<double>(x.size()));
      value += 0.5 * curvature * x[i] * x[i];
      if (!gradient.empty()) gradient[i] = curvature * x[i];
    }
    return true;
  }
};

TEST(Fallback, AWindowOfZeroIsThatOfTheMethod) {
  const auto stopped = [](const char* name, int window) {
    SlowBowl problem;
    SolverOptions options;
    options.name = name;
    std::vector<double> x(problem.size(), 1.0);
    return minimize_with_fallback(
        options, problem, x,
        {.max_iterations = 5000, .relative_decrease = 1, .decrease_window = window, .gradient_norm = 0});
  };
  for (const char* name : {"lbfgs", "fletcher_reeves", "ceres_ncg", "nlopt_lbfgs"}) {
    EXPECT_NE(stopped(name, 0).message.find("over 50 iterations"), std::string::npos)
        << name << ": " << stopped(name, 0).message;
    EXPECT_NE(stopped(name, 3).message.find("over 3 iterations"), std::string::npos)
        << name << ": " << stopped(name, 3).message;
  }
}

TEST(Fallback, UnknownMethodsAreNamed) {
  SolverOptions options;
  options.fallback = {"lbfgs", "lfbgs"};
  try {
    make_minimizer(options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("solver.fallback: there is no method 'lfbgs', did you mean 'lbfgs'?"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace shellmatch
