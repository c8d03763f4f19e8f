// Every method on every published problem, through the one interface.
#include "solvers/solver_options.h"
#include "tests/support/published_trials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace shellmatch {
namespace {

class EveryMinimizer : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryMinimizer, SolvesThePublishedProblems) {
  for (const auto& problem : testing::more_garbow_hillstrom()) {
    SCOPED_TRACE(GetParam() + " on " + problem->name());
    const testing::Trial trial = testing::try_method(GetParam(), *problem);
    const std::string expected = testing::expected_failure(GetParam(), problem->name());
    if (expected.empty())
      EXPECT_EQ(trial.wrong, "") << trial.summary.message << " after " << trial.summary.iterations << " iterations";
    else EXPECT_NE(trial.wrong, "") << "works now, though it was expected to fail: " << expected;
  }
}

TEST_P(EveryMinimizer, FindsItsWayAlongAnEdgeBeyondWhichNothingCanBeEvaluated) {
  SolverOptions options;
  options.name = GetParam();
  options.ceres = testing::without_tolerances();
  options.stop = {
      .max_iterations = 20000, .relative_decrease = 0, .decrease_window = 10, .gradient_norm = 1e-9, .max_seconds = 20};
  for (const double mu : {0.1, 0.01}) {
    const auto problem = testing::log_barrier(10, mu);
    std::vector<double> x = problem->start();
    const MinimizerSummary summary = make_minimizer(options)->minimize(*problem, x, options.stop);
    EXPECT_EQ(problem->check(summary.final_value, x, 1e-6), "") << options.name << ": " << summary.message;
  }
}

TEST_P(EveryMinimizer, KeepsAnHonestRecord) {
  SolverOptions options;
  options.name = GetParam();
  options.stop = {
      .max_iterations = 15, .relative_decrease = 0, .decrease_window = 10, .gradient_norm = 0, .max_seconds = 0};
  // An objective that counts for itself what it is asked.
  struct Counting final : testing::UnitModel {
    std::unique_ptr<testing::TestProblem> inner = testing::weighted_bowl(60);
    long values = 0, gradients = 0;
    std::size_t size() const override { return inner->size(); }
    bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
      ++values;
      if (!gradient.empty()) ++gradients;
      return inner->evaluate(x, value, gradient);
    }
    std::vector<std::string> term_names() const override { return inner->term_names(); }
    std::vector<double> term_values() const override { return inner->term_values(); }
  } objective;
  std::vector<double> x = objective.inner->start();
  std::vector<IterationRecord> records;
  const MinimizerSummary summary =
      make_minimizer(options)->minimize(objective, x, options.stop, [&](const IterationRecord& r) {
        records.push_back(r);
        return true;
      });
  ASSERT_EQ(static_cast<int>(records.size()), summary.iterations + 1);
  EXPECT_LE(summary.iterations, 15);
  EXPECT_EQ(summary.value_evaluations, objective.values);
  EXPECT_EQ(summary.gradient_evaluations, objective.gradients);
  EXPECT_EQ(summary.initial_value, records.front().value);
  EXPECT_EQ(summary.final_value, records.back().value);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].iteration, static_cast<int>(i));
    ASSERT_EQ(records[i].terms.size(), 2u);
    EXPECT_NEAR(records[i].terms[0] + records[i].terms[1], records[i].value, 1e-14 * records[i].value);
    if (i == 0) continue;
    EXPECT_LE(records[i].value, records[i - 1].value);
    EXPECT_GT(records[i].step, 0);
    EXPECT_GE(records[i].seconds, records[i - 1].seconds);
  }
  double at_x = 0;
  std::vector<double> g(x.size());
  ASSERT_TRUE(objective.inner->evaluate(x, at_x, g));
  EXPECT_EQ(at_x, summary.final_value);
  double squared = 0;
  for (const double d : g) squared += d * d;
  EXPECT_NEAR(std::sqrt(squared), records.back().gradient_norm, 1e-12 * std::sqrt(squared));
}

std::string method_of(const ::testing::TestParamInfo<std::string>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Methods, EveryMinimizer, ::testing::ValuesIn(minimizer_names()), method_of);

// The variants of the paper's method that options reach, its letter among them.
TEST(FletcherReevesVariants, AllSolveRosenbrock) {
  const auto solve = [](const FletcherReevesOptions& o, double tolerance = 1e-7) {
    SolverOptions options;
    options.fletcher_reeves = o;
    options.stop = {.max_iterations = 30000,
                    .relative_decrease = 0,
                    .decrease_window = 10,
                    .gradient_norm = 1e-9,
                    .max_seconds = 20};
    const auto problem = testing::extended_rosenbrock(50);
    std::vector<double> x = problem->start();
    const auto summary = make_minimizer(options)->minimize(*problem, x, options.stop);
    return summary.final_value <= tolerance;
  };
  FletcherReevesOptions paper;
  paper.interpolation = Interpolation::halving;
  paper.initial_step = InitialStep::memory;
  paper.first_step = 1;
  paper.step_growth = 1;
  paper.least_cosine = 0;
  EXPECT_TRUE(solve(paper, 1e-4));  // a step that only ever shrinks creeps in the end
  for (const auto interpolation : {Interpolation::halving, Interpolation::quadratic, Interpolation::cubic})
    for (const auto initial : {InitialStep::memory, InitialStep::slope, InitialStep::decrease, InitialStep::curvature})
      for (const double curvature : {0.0, 0.3}) {
        FletcherReevesOptions o;
        o.interpolation = interpolation;
        o.initial_step = initial;
        o.curvature = curvature;
        EXPECT_TRUE(solve(o)) << enum_name(interpolation) << ", " << enum_name(initial) << ", " << curvature;
      }
  FletcherReevesOptions restarts;
  restarts.restart_every = 20;
  restarts.orthogonality = 0.2;
  EXPECT_TRUE(solve(restarts));
  FletcherReevesOptions polak_ribiere;
  polak_ribiere.update = ConjugateUpdate::bounded_polak_ribiere;
  polak_ribiere.gradient_trials = 0;
  EXPECT_TRUE(solve(polak_ribiere));
}

}  // namespace
}  // namespace shellmatch
