// Names, ranges and messages.
#include "base/error.h"
#include "solvers/solver_options.h"
#include "tests/support/test_problems.h"

#include <gtest/gtest.h>

#include <string>

namespace shellmatch {
namespace {

std::string message_of(const SolverOptions& options) {
  try {
    make_minimizer(options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(MakeMinimizer, EveryNameMakesAMinimizerOfThatName) {
  for (const std::string& name : minimizer_names()) {
    SolverOptions options;
    options.name = name;
    EXPECT_EQ(make_minimizer(options)->name(), name);
  }
}

TEST(MakeMinimizer, UnknownNameSaysWhatThereIs) {
  SolverOptions options;
  options.name = "fletcher_reves";
  const std::string text = message_of(options);
  EXPECT_TRUE(contains(text, "did you mean 'fletcher_reeves'?")) << text;
  for (const std::string& name : minimizer_names()) EXPECT_TRUE(contains(text, name)) << text;
  options.name = "simulated_annealing";
  EXPECT_FALSE(contains(message_of(options), "did you mean"));
}

TEST(MakeMinimizer, OptionsOutOfRangeAreNamed) {
  SolverOptions options;
  options.fletcher_reeves.step_growth = 0.7;
  EXPECT_TRUE(contains(message_of(options), "solver.fletcher_reeves.step_growth = 0.7")) << message_of(options);
  options = {};
  options.stop.decrease_window = -1;
  EXPECT_TRUE(contains(message_of(options), "solver.stop.decrease_window = -1")) << message_of(options);
}

TEST(MakeMinimizer, CeresOptionsThatDoNotGoTogetherAreRefused) {
  SolverOptions options;
  options.name = "ceres_lbfgs";
  options.ceres.line_search_type = CeresLineSearch::armijo;
  EXPECT_TRUE(contains(message_of(options), "ceres_lbfgs")) << message_of(options);
  options.name = "ceres_ncg";
  EXPECT_EQ(message_of(options), "");
}

TEST(MakeMinimizer, DenseMethodsRefuseLargeProblems) {
  const auto problem = testing::extended_rosenbrock(20);
  std::vector<double> x = problem->start();
  SolverOptions options;
  options.ceres.max_bfgs_size = 19;
  options.name = "ceres_bfgs";
  EXPECT_THROW(make_minimizer(options)->minimize(*problem, x, {}), InputError);
}

// All conjugate gradients and both line searches of Ceres, reached by option alone.
TEST(CeresVariants, AllSolveRosenbrock) {
  for (const auto& [cg, cg_name] : EnumNames<CeresConjugateGradient>::names)
    for (const auto& [line_search, line_search_name] : EnumNames<CeresLineSearch>::names) {
      SolverOptions options;
      options.name = "ceres_ncg";
      options.ceres = testing::without_tolerances();
      options.ceres.nonlinear_conjugate_gradient_type = cg;
      options.ceres.line_search_type = line_search;
      options.stop = {.max_iterations = 30000,
                      .relative_decrease = 0,
                      .decrease_window = 10,
                      .gradient_norm = 1e-8,
                      .max_seconds = 20};
      const auto problem = testing::extended_rosenbrock(2);
      std::vector<double> x = problem->start();
      const auto summary = make_minimizer(options)->minimize(*problem, x, options.stop);
      // By value alone. Armijo's rule does not make directions of Hestenes and Stiefel descend: Ceres may give up
      // before the minimum, at a point that hangs on the last digits.
      const bool may_give_up = cg == CeresConjugateGradient::hestenes_stiefel && line_search == CeresLineSearch::armijo;
      EXPECT_LT(summary.final_value, may_give_up ? 1e-3 : 1e-6)
          << cg_name << ", " << line_search_name << ": " << summary.message;
    }
}

}  // namespace
}  // namespace shellmatch
