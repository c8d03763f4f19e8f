#pragma once
/// \file
/// Keeps a library that iterates by itself under the rules that hold for our own methods.

#include "solvers/minimization_run.h"

#include <exception>
#include <span>
#include <vector>

namespace shellmatch {

/// Stands between a library and the run. It keeps the best point that was ever evaluated, answers a second
/// question about that point from memory, and holds exceptions back until the library has been left: C code
/// cannot be thrown through.
class LibraryRun {
 public:
  LibraryRun(Objective& objective, const std::vector<double>& x, const StopOptions& stop,
             const IterationCallback& callback);

  /// As MinimizationRun::start.
  bool start();

  /// As MinimizationRun::evaluate, but throws nothing and answers nothing once `halted()`.
  Evaluation evaluate(std::span<const double> x, std::span<double> gradient) noexcept;

  /// Records the best point as an accepted step, if it was not recorded yet. Throws nothing. False: halt.
  bool accept_best() noexcept;

  /// True where the library has to be left: the run is over, time is up, or something was thrown.
  bool halted() const { return run_.over() || exception_ || run_.out_of_time(); }

  /// Evaluations since the best point was found.
  int stalled_evaluations() const { return stalled_; }

  double best_value() const { return best_.value; }
  double best_gradient_norm() const { return best_.gradient_norm; }
  const std::vector<double>& best_x() const { return best_x_; }

  /// To be called when the library has been left: throws what was held back, records a best point that is not
  /// recorded yet, ends the run, hands the best point to x.
  MinimizerSummary finish(std::vector<double>& x, StopReason reason, std::string message);

 private:
  void keep(std::span<const double> x, std::span<const double> gradient, const Evaluation& at);

  MinimizationRun run_;
  std::vector<double> best_x_, best_gradient_, best_terms_;
  std::vector<double> recorded_x_;  ///< best point of the last record, from which steps are measured
  Evaluation best_;
  bool best_has_gradient_ = true, recorded_ = true;
  int stalled_ = 0;
  std::exception_ptr exception_;
};

}  // namespace shellmatch
