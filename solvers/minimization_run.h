#pragma once
/// \file
/// One minimisation under way: what all methods share, so that their records can be compared.

#include "solvers/minimizer.h"
#include "solvers/stop_monitor.h"

#include <span>
#include <string>
#include <vector>

namespace shellmatch {

/// Outcome of one evaluation.
struct Evaluation {
  bool feasible = false;  ///< false: cannot be evaluated here, or value or gradient not finite
  double value = 0;
  double gradient_norm = 0;  ///< Euclidean; only where the gradient was asked for
  double l2_gradient_norm = 0;  ///< as Objective::l2_gradient_norm; only there too
};

/// Counts evaluations, keeps the record, applies the stop rules and calls the caller back. A method evaluates
/// through it, reports every accepted step to it, and leaves off once `over()`.
class MinimizationRun {
 public:
  /// Keeps references: objective and callback must outlive it. The clock starts here.
  MinimizationRun(Objective& objective, const StopOptions& stop, const IterationCallback& callback);

  std::size_t size() const { return objective_.size(); }

  /// Evaluates the start with its gradient and records it. False where the run is over already: the start
  /// cannot be evaluated, the gradient is zero, there are no unknowns, or a stop rule holds.
  bool start(std::span<const double> x, std::span<double> gradient);

  /// Value at x, and the gradient where its span is not empty.
  Evaluation evaluate(std::span<const double> x, std::span<double> gradient);

  /// Weighted terms at the last point evaluated.
  std::vector<double> term_values() const { return objective_.term_values(); }

  /// Records a step that was accepted; `step` is its norm. False where the run is over by it.
  bool accept(const Evaluation& at, double step, std::vector<double> terms);
  bool accept(const Evaluation& at, double step) { return accept(at, step, term_values()); }

  /// True once a reason to stop is known. Long inner loops ask also `out_of_time()`.
  bool over() const { return over_; }
  bool out_of_time() const { return monitor_.out_of_time(); }

  /// Ends the run for a reason of the method's; does nothing where it is over already. An empty message is
  /// replaced by the reason in words; where time has run out, that is the reason.
  void finish(StopReason reason, std::string message = {});

  double start_value() const { return summary_.initial_value; }
  double start_gradient_norm() const { return start_.gradient_norm; }
  const Evaluation& start_evaluation() const { return start_; }

  /// The account of the whole, to be taken at the end.
  MinimizerSummary summary() const;

 private:
  bool report(IterationRecord record);

  Objective& objective_;
  const IterationCallback& callback_;
  StopMonitor monitor_;
  MinimizerSummary summary_;
  Evaluation start_;
  bool over_ = false;
};

}  // namespace shellmatch
