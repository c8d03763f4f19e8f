#pragma once
/// \file
/// Ceres' GradientProblemSolver behind our interface.

#include "solvers/libraries/library_options.h"
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

/// A line search method of Ceres. Ceres' own tolerances are switched off and its logging silenced; an
/// iteration is one of Ceres'. Where Ceres gives up, StopReason::library and its message say so, and the best
/// point that was evaluated is kept. Exceptions of the objective and of the callback pass through.
///
/// Ceres never tries a step longer than its direction, so steepest descent and conjugate gradients creep on
/// functions whose second derivatives are much smaller than 1 in the chosen metric.
class CeresMinimizer final : public Minimizer {
 public:
  /// \throws InputError where Ceres finds that the options do not go together; the message is Ceres'.
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
