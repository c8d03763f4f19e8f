#pragma once
/// \file
/// Applies the stop rules and the record of MinimizationRun to a library that controls its own iteration.

#include "solvers/minimization_run.h"

#include <exception>
#include <span>
#include <vector>

namespace shellmatch {

/// Mediates between a library and the run. It stores the best point evaluated so far, returns its value and
/// gradient without a new evaluation, and stores exceptions until the library has returned, because they must
/// not propagate through C code.
class LibraryRun {
 public:
  LibraryRun(Objective& objective, const std::vector<double>& x, const StopOptions& stop,
             const IterationCallback& callback);

  /// See MinimizationRun::start().
  bool start();

  /// See MinimizationRun::evaluate(). Throws nothing; evaluates nothing once halted().
  Evaluation evaluate(std::span<const double> x, std::span<double> gradient) noexcept;

  /// Records the best point as an accepted step unless it has been recorded. Throws nothing. Returns false if
  /// the library must stop.
  bool accept_best() noexcept;

  /// True if the library must stop: the run is over, the time limit is reached, or an exception was thrown.
  bool halted() const { return run_.over() || exception_ || run_.out_of_time(); }

  /// Call before the library is started once more from the best point.
  void begin_again() { stalled_ = 0; }

  /// Number of evaluations since the best point was found, or since begin_again().
  int stalled_evaluations() const { return stalled_; }

  double best_value() const { return best_.value; }
  double best_gradient_norm() const { return best_.gradient_norm; }
  const std::vector<double>& best_x() const { return best_x_; }

  /// Call after the library has returned. Rethrows a stored exception, records the best point if that is
  /// still to be done, ends the run, and sets x to the best point.
  MinimizerSummary finish(std::vector<double>& x, StopReason reason, std::string message);

 private:
  void keep(std::span<const double> x, std::span<const double> gradient, const Evaluation& at);

  MinimizationRun run_;
  std::vector<double> best_x_, best_gradient_, best_terms_;
  std::vector<double> recorded_x_;  ///< best point at the last record; the norm of the next step is measured from it
  Evaluation best_;
  bool best_has_gradient_ = true, recorded_ = true;
  int stalled_ = 0;
  std::exception_ptr exception_;
};

}  // namespace shellmatch
