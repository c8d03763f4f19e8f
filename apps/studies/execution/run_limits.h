#pragma once
/// \file
/// What one run of a study or a cohort may cost.

#include "base/options.h"

namespace shellmatch {

/// Limits of one run. A run that exceeds them is ended, which is then its result.
struct RunLimits {
  double seconds = 600, grace_seconds = 5, memory_mb = 0;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("seconds", self.seconds, {.unit = "seconds", .min = 0, .meaning = "wall time of one run; 0 means none"});
    visit("grace_seconds", self.grace_seconds,
          {.unit = "seconds",
           .min = 0,
           .max = 3600,
           .meaning = "a run that is out of time is first asked to stop, which leaves nothing half written; so much "
                      "later it is killed"});
    visit("memory_mb", self.memory_mb,
          {.unit = "MB",
           .min = 0,
           .max = 1e9,
           .meaning = "resident memory of one run with its child processes; 0 means none"});
  }
};

}  // namespace shellmatch
