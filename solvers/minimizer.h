#pragma once
/// \file
/// The interface of all minimisers, their records and their stop rules.

#include "base/options.h"
#include "solvers/objective.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// The stop rules. They are the same, and measured in the same way, for every method.
struct StopOptions {
  int max_iterations = 1000;
  double relative_decrease = 1e-6;
  int decrease_window = 10;
  double restrained_factor = 1;
  double gradient_norm = 1e-9;
  double max_seconds = 0;
  static void describe(auto& self, auto& visit) {
    visit("max_iterations", self.max_iterations, {.unit = "iterations", .min = 0, .meaning = "most accepted steps"});
    visit("relative_decrease", self.relative_decrease,
          {.min = 0,
           .meaning = "stop when the value fell by less than this share of itself over `decrease_window` iterations"});
    visit("decrease_window", self.decrease_window,
          {.unit = "iterations",
           .min = 0,
           .meaning =
               "number of iterations over which `relative_decrease` is measured; 0: 1 for Newton's method, 50 for the "
               "others, whose steps cost about a fiftieth (minimize_with_fallback; Minimizer::minimize takes 0 as 1)"});
    visit("gradient_norm", self.gradient_norm,
          {.min = 0,
           .meaning = "stop when the gradient's norm in the chosen metric is at most this share of its first value"});
    visit("max_seconds", self.max_seconds,
          {.unit = "seconds", .min = 0, .meaning = "time limit for one minimisation; 0 means none"});
  }
};

/// Record of one accepted step, the same for every method.
struct IterationRecord {
  int iteration = 0;  ///< 0 is the initial point
  double value = 0;
  std::vector<double> terms;      ///< as Objective::term_values
  double gradient_norm = 0;       ///< in the metric of the minimisation
  double l2_gradient_norm = 0;    ///< in L2 for every metric, so that methods are comparable
  double step = 0;                ///< norm of the step in that metric
  long value_evaluations = 0;     ///< so far, including those with gradient
  long gradient_evaluations = 0;  ///< so far
  double seconds = 0;             ///< since the start of this minimisation
  std::string solver;             ///< name of the method (solvers/methods/fallback.h)
  bool shortened = false;         ///< did the line search of a method whose natural step is 1 take less?
  bool restrained =
      false;  ///< did the step lead beyond the model in all its systems (StepRegularisation::is_restrained)?
};

/// `library`: a library gave up; `converged`: by a tolerance of its own.
enum class StopReason {
  relative_decrease,
  gradient_norm,
  max_iterations,
  max_seconds,
  no_descent,
  cannot_evaluate_start,
  interrupted,
  library,
  converged,
};
template <>
struct EnumNames<StopReason> {
  static constexpr std::pair<StopReason, std::string_view> names[] = {
      {StopReason::relative_decrease, "relative_decrease"},
      {StopReason::gradient_norm, "gradient_norm"},
      {StopReason::max_iterations, "max_iterations"},
      {StopReason::max_seconds, "max_seconds"},
      {StopReason::no_descent, "no_descent"},
      {StopReason::cannot_evaluate_start, "cannot_evaluate_start"},
      {StopReason::interrupted, "interrupted"},
      {StopReason::library, "library"},
      {StopReason::converged, "converged"}};
};

/// What a library says of a minimisation in its own words: Ceres' BriefReport() and FullReport().
struct LibraryReport {
  std::string brief, full;
};

struct MinimizerSummary {
  StopReason reason = StopReason::max_iterations;
  std::string message;                        ///< of the method, one line
  double initial_value = 0, final_value = 0;  ///< NaN where the function cannot be evaluated at the start
  /// In the metric of the minimisation; after a fallback the one in that of the first method, the other in that of the
  /// last.
  double initial_gradient_norm = 0, final_gradient_norm = 0;
  int iterations = 0;
  long value_evaluations = 0, gradient_evaluations = 0;
  long linear_iterations = 0;    ///< of conjugate gradients, for the steps of Newton's method
  long regularised_systems = 0;  ///< of these steps, each up to max_regularisations times
  double seconds = 0;
  std::string solver;                          ///< name of the last method
  std::vector<LibraryReport> library_reports;  ///< one for each of the methods that has one
  std::vector<std::string> fallbacks;          ///< one line for every method that failed before it
};

/// Called for the initial point and after every accepted step; return false to stop
/// (StopReason::interrupted).
using IterationCallback = std::function<bool(const IterationRecord&)>;

/// A method of minimisation. It holds options only, so one object can solve several problems in turn.
class Minimizer {
 public:
  virtual ~Minimizer() = default;
  virtual std::string name() const = 0;

  /// True if the method depends on the metric. Newton's method does not.
  virtual bool uses_metric() const { return true; }

  /// Minimises from the initial point x and sets x to the best point found. A lack of convergence is not an
  /// exception: the summary states why the method stopped.
  virtual MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                                    const IterationCallback& callback = {}) const = 0;
};

}  // namespace shellmatch
