#pragma once
/// \file
/// The stop rules of a minimisation, applied in the same way to every method.

#include "solvers/minimizer.h"

#include <chrono>
#include <optional>
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

}  // namespace shellmatch
