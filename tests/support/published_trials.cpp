#include "tests/support/published_trials.h"

#include "base/error.h"

#include <algorithm>
#include <map>
#include <utility>

namespace shellmatch::testing {

namespace {

constexpr int max_bfgs_size = 500;  // less than the default, to keep the test short

// First-order models without memory creep along valleys.
bool slow(const std::string& method) {
  return method == "ceres_steepest_descent" || method == "nlopt_mma" || method == "nlopt_ccsaq";
}

}  // namespace

Trial try_method(const std::string& method, TestProblem& problem) {
  SolverOptions options;
  options.name = method;
  options.ceres = without_tolerances();
  options.ceres.max_bfgs_size = max_bfgs_size;
  options.stop = {.max_iterations = 20000,
                  .relative_decrease = 0,
                  .decrease_window = 10,
                  .gradient_norm = 1e-10,
                  .max_seconds = 20};
  Trial trial;
  std::vector<double> x = problem.start();
  try {
    trial.summary = make_minimizer(options)->minimize(problem, x, options.stop);
    // The extended problems are sums of n / 4 copies and more.
    const double scale = std::max(1.0, static_cast<double>(problem.size()) / 4);
    trial.wrong = problem.check(trial.summary.final_value, x, (slow(method) ? 1e-6 : 1e-8) * scale);
  } catch (const InputError& error) {
    trial.wrong = error.what();
  }
  return trial;
}

std::string expected_failure(const std::string& method, const std::string& problem) {
  // A pair that works after all makes the test fail, so that the table stays true.
  static const std::map<std::pair<std::string, std::string>, std::string> reasons = {
      {{"ceres_bfgs", "extended_rosenbrock_1000"}, "dense: above max_bfgs_size, 500 here"},
      {{"ceres_bfgs", "extended_powell_1000"}, "dense: above max_bfgs_size, 500 here"},
  };
  const auto found = reasons.find({method, problem});
  return found == reasons.end() ? "" : found->second;
}

}  // namespace shellmatch::testing
