#pragma once
/// \file
/// Adapter of Ceres' GradientProblemSolver.

#include "solvers/library_options.h"
#include "solvers/minimizer.h"

namespace shellmatch {

enum class CeresMethod { steepest_descent, ncg, bfgs, lbfgs };
template <>
struct EnumNames<CeresMethod> {
  static constexpr std::pair<CeresMethod, std::string_view> names[] = {
      {CeresMethod::steepest_descent, "ceres_steepest_descent"},
      {CeresMethod::ncg, "ceres_ncg"},
      {CeresMethod::bfgs, "ceres_bfgs"},
      {CeresMethod::lbfgs, "ceres_lbfgs"}};
};

/// A line search method of Ceres, with its own tolerances and line search. Its iterates are recorded, and its last one
/// is returned. StopReason::converged and StopReason::library (Ceres failed) come with Ceres' message; the summary has
/// Ceres' reports. The common stop rules are a callback (CeresOptions::common_stop_rules); StopOptions::max_iterations
/// and max_seconds are limits of Ceres itself. Exceptions of the objective and of the callback are passed to the
/// caller.
///
/// Ceres never tries a step longer than its search direction, so steepest descent and conjugate gradients
/// converge slowly where the second derivatives are much smaller than 1 in the chosen metric.
class CeresMinimizer final : public Minimizer {
 public:
  /// \throws InputError with Ceres' message where Ceres finds the options inconsistent.
  CeresMinimizer(CeresMethod method, const CeresOptions& options = {});
  std::string name() const override { return std::string(enum_name(method_)); }

  /// \throws InputError for ceres_bfgs with more than max_bfgs_size unknowns.
  MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                            const IterationCallback& callback = {}) const override;

 private:
  CeresMethod method_;
  CeresOptions options_;
};

}  // namespace shellmatch
