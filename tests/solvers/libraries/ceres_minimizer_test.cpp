// Ceres' methods as Ceres runs them: its iterates, its tolerances, its reports.
#include "solvers/libraries/ceres_minimizer.h"
#include "tests/support/test_problems.h"

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

const StopOptions no_rules{.max_iterations = 300, .relative_decrease = 0, .decrease_window = 10, .gradient_norm = 0};

/// The problem without anything of ours between it and Ceres.
class Bare final : public ceres::FirstOrderFunction {
 public:
  explicit Bare(testing::TestProblem& problem) : problem_(problem) {}
  bool Evaluate(const double* x, double* value, double* gradient) const override {
    return problem_.evaluate({x, problem_.size()}, *value, {gradient, gradient ? problem_.size() : 0});
  }
  int NumParameters() const override { return static_cast<int>(problem_.size()); }

 private:
  testing::TestProblem& problem_;
};

ceres::LineSearchDirectionType direction_of(CeresMethod method) {
  switch (method) {
    case CeresMethod::steepest_descent: return ceres::STEEPEST_DESCENT;
    case CeresMethod::ncg: return ceres::NONLINEAR_CONJUGATE_GRADIENT;
    case CeresMethod::bfgs: return ceres::BFGS;
    case CeresMethod::lbfgs: break;
  }
  return ceres::LBFGS;
}

TEST(CeresMinimizer, RecordsWhatCeresReturns) {
  for (const auto& [method, name] : EnumNames<CeresMethod>::names)
    for (const auto& problem : testing::more_garbow_hillstrom()) {
      if (problem->size() > 200) continue;
      SCOPED_TRACE(std::string(name) + " on " + problem->name());
      ceres::GradientProblemSolver::Options options;  // with all its defaults
      options.line_search_direction_type = direction_of(method);
      options.max_num_iterations = no_rules.max_iterations;
      options.logging_type = ceres::SILENT;
      std::vector<double> expected = problem->start();
      ceres::GradientProblemSolver::Summary report;
      ceres::Solve(options, ceres::GradientProblem(new Bare(*problem)), expected.data(), &report);

      std::vector<double> x = problem->start();
      std::vector<IterationRecord> records;
      const auto summary = CeresMinimizer(method).minimize(*problem, x, no_rules, [&](const IterationRecord& r) {
        records.push_back(r);
        return true;
      });
      EXPECT_EQ(x, expected);
      EXPECT_EQ(summary.final_value, report.final_cost);
      EXPECT_EQ(summary.message, "Ceres: " + report.message);
      EXPECT_EQ(summary.reason == StopReason::converged, report.termination_type == ceres::CONVERGENCE);
      ASSERT_GE(records.size(), report.iterations.size());
      for (std::size_t i = 0; i < report.iterations.size(); ++i) {
        EXPECT_EQ(records[i].value, report.iterations[i].cost);
        EXPECT_NEAR(records[i].gradient_norm, report.iterations[i].gradient_norm,
                    1e-10 * records[i].gradient_norm + 1e-15);
        EXPECT_NEAR(records[i].step, report.iterations[i].step_norm, 1e-9 * records[i].step + 1e-15);
      }
      EXPECT_EQ(records.back().value, report.final_cost);
      ASSERT_EQ(summary.library_reports.size(), 1u);
      EXPECT_NE(summary.library_reports[0].brief.find(fmt::format("Iterations: {}", report.iterations.size())),
                std::string::npos)
          << summary.library_reports[0].brief;
      EXPECT_NE(summary.library_reports[0].full.find("Line search direction"), std::string::npos);
    }
}

TEST(CeresMinimizer, CommonStopRulesCanBeSwitchedOff) {
  const auto problem = testing::extended_rosenbrock(20);
  StopOptions early = no_rules;
  early.relative_decrease = 0.9;
  early.decrease_window = 1;
  CeresOptions options;
  for (const bool common : {true, false}) {
    options.common_stop_rules = common;
    std::vector<double> x = problem->start();
    const auto summary = CeresMinimizer(CeresMethod::lbfgs, options).minimize(*problem, x, early);
    EXPECT_EQ(summary.reason, common ? StopReason::relative_decrease : StopReason::converged) << summary.message;
    EXPECT_EQ(summary.final_value < 1e-6, !common);
  }
  // The limits stay, as those of Ceres itself.
  early.max_iterations = 5;
  std::vector<double> x = problem->start();
  const auto summary = CeresMinimizer(CeresMethod::lbfgs, options).minimize(*problem, x, early);
  EXPECT_EQ(summary.reason, StopReason::max_iterations);
  EXPECT_EQ(summary.iterations, 5);
}

TEST(CeresMinimizer, TakesCeresToleranceFromItsOptions) {
  const auto problem = testing::extended_rosenbrock(20);
  CeresOptions options;
  options.function_tolerance = 0.5;
  std::vector<double> x = problem->start();
  const auto loose = CeresMinimizer(CeresMethod::lbfgs, options).minimize(*problem, x, no_rules);
  EXPECT_EQ(loose.reason, StopReason::converged);
  EXPECT_NE(loose.message.find("Function tolerance"), std::string::npos) << loose.message;
  EXPECT_GT(loose.final_value, 1e-3);
}

}  // namespace
}  // namespace shellmatch
