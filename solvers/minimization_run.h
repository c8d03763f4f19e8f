#pragma once
/// \file
/// State of one minimisation that all methods share, with its stop rules, so that their records are comparable.

#include "solvers/minimizer.h"

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace shellmatch {

/// Monitors one minimisation. The constructor starts the clock.
class StopMonitor {
 public:
  explicit StopMonitor(const StopOptions& options);

  /// Call with the initial point (iteration 0) and then with every accepted step. Returns the rule that ends
  /// the minimisation, if any; of several, the first in the order gradient_norm, relative_decrease,
  /// max_iterations, max_seconds. A zero gradient always ends it.
  std::optional<StopReason> check(const IterationRecord& record);

  double seconds() const;
  bool out_of_time() const { return options_.max_seconds > 0 && seconds() >= options_.max_seconds; }

  /// The rule in words, with its limit.
  std::string message(StopReason reason) const;

 private:
  StopOptions options_;
  std::chrono::steady_clock::time_point start_;
  double first_gradient_norm_ = 0;
  int n_small_ = 0;             ///< decreases in a row that are less than asked for
  double decrease_;             ///< the relative decrease that was asked for last
  std::vector<double> window_;  ///< the last decrease_window + 1 values, a ring buffer
};

/// Outcome of one evaluation.
struct Evaluation {
  bool feasible = false;  ///< false where the function cannot be evaluated, or value or gradient are not finite
  double value = 0;
  double gradient_norm = 0;     ///< Euclidean; only if the gradient was requested
  double l2_gradient_norm = 0;  ///< as Objective::l2_gradient_norm; only if the gradient was requested
};

/// Counts evaluations, keeps the records, applies the stop rules and invokes the callback. A method evaluates
/// the objective through it, reports every accepted step to it, and stops once over() returns true.
class MinimizationRun {
 public:
  /// Keeps references to the objective and the callback, which must outlive it. Starts the clock.
  MinimizationRun(Objective& objective, const StopOptions& stop, const IterationCallback& callback);

  std::size_t size() const { return objective_.size(); }

  /// Evaluates and records the initial point with its gradient. Returns false if the run is over: the point
  /// cannot be evaluated, the gradient is zero, there are no unknowns, or a stop rule applies.
  bool start(std::span<const double> x, std::span<double> gradient);

  /// Value at x, and the gradient if its span is not empty.
  Evaluation evaluate(std::span<const double> x, std::span<double> gradient);

  /// Weighted terms at the point evaluated last.
  std::vector<double> term_values() const { return objective_.term_values(); }

  /// Records an accepted step; `step` is its norm, `shortened` and `restrained` as in IterationRecord. Returns false if
  /// the run is over.
  bool accept(const Evaluation& at, double step, std::vector<double> terms, bool shortened = false,
              bool restrained = false);
  bool accept(const Evaluation& at, double step) { return accept(at, step, term_values()); }

  /// True once there is a reason to stop. Long inner loops check out_of_time() as well.
  bool over() const { return over_; }
  bool out_of_time() const { return monitor_.out_of_time(); }

  /// Ends the run for a reason of the method; has no effect if the run is over. An empty message is replaced
  /// by the description of the reason. If the time limit has been reached, that is the reason.
  void finish(StopReason reason, std::string message = {});

  /// Ends the run because no step lowers the value. The message says what is not finite at `infeasible`, the last trial
  /// point if it could not be evaluated, and otherwise empty.
  void finish_without_descent(std::span<const double> infeasible);

  double start_value() const { return summary_.initial_value; }
  double start_gradient_norm() const { return start_.gradient_norm; }
  const Evaluation& start_evaluation() const { return start_; }

  /// The summary of the run, once it is over.
  MinimizerSummary summary() const;

 private:
  bool report(IterationRecord record);
  /// The message with what is not finite at x, if that is known.
  std::string explained(std::string message, std::span<const double> x);

  Objective& objective_;
  const IterationCallback& callback_;
  StopMonitor monitor_;
  MinimizerSummary summary_;
  Evaluation start_;
  bool over_ = false;
};

}  // namespace shellmatch
