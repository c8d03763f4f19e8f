#pragma once
/// \file
/// The rules by which a minimisation ends, applied in the same way to every method.

#include "solvers/minimizer.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// Watches one minimisation. The clock starts with the object.
class StopMonitor {
 public:
  explicit StopMonitor(const StopOptions& options);

  /// Takes the start (iteration 0) and then every accepted step, and tells which rule ends the minimisation.
  /// Where several do, the first in this order is named: gradient_norm, relative_decrease, max_iterations,
  /// max_seconds. A gradient of zero always ends it.
  std::optional<StopReason> check(const IterationRecord& record);

  double seconds() const;
  bool out_of_time() const { return options_.max_seconds > 0 && seconds() >= options_.max_seconds; }

  /// The rule in words, with its number.
  std::string message(StopReason reason) const;

 private:
  StopOptions options_;
  std::chrono::steady_clock::time_point start_;
  double first_gradient_norm_ = 0;
  std::vector<double> window_;  ///< the last decrease_window + 1 values, as a ring
};

}  // namespace shellmatch
