#pragma once
/// \file
/// Measures the cost of a matching for its summary.

#include "matching/progress/phase_clock.h"
#include "matching/result/match_summary.h"

#include <chrono>

namespace shellmatch {

/// Wall times of a matching since the construction of this object, and of earlier runs from which it was resumed.
class RunClock {
 public:
  /// Seconds by phase, set by PhaseClock.
  PhaseSeconds phases;

  /// Adds the times of the levels that earlier runs have finished.
  void add_earlier(const RunFigures& figures);

  /// Seconds since the construction, of this process alone.
  double seconds() const;

  /// Sets times, memory, threads and compiler in `figures`; leaves `level_seconds` and `resumed_after` unchanged.
  void state(RunFigures& figures) const;

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double earlier_ = 0;
};

}  // namespace shellmatch
