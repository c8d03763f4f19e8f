#pragma once
/// \file
/// What a matching costs, for its summary.

#include "matching/progress/phase_clock.h"
#include "matching/result/match_summary.h"

#include <chrono>

namespace shellmatch {

/// Wall times of a matching since this object was made, and those of earlier ones that it goes on from.
class RunClock {
 public:
  /// By phase, filled by PhaseClock.
  PhaseSeconds phases;

  /// Adds what the levels that were finished before have taken.
  void add_earlier(const RunFigures& figures);

  /// Of this process alone.
  double seconds() const;

  /// Sets times, memory, threads and compiler in `figures`; its `level_seconds` and `resumed_after` stay.
  void state(RunFigures& figures) const;

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double earlier_ = 0;
};

}  // namespace shellmatch
