#pragma once
/// \file
/// One run of the program, and what it may cost.

#include "base/options.h"

#include <string>

namespace shellmatch {

/// Limits of one run. A run that exceeds them is ended, which is then its result.
struct RunLimits {
  double seconds = 600, grace_seconds = 5, memory_mb = 0;
  static void describe(auto& self, auto& visit) {
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

/// A run of the program in a process and a folder of its own.
struct RunTask {
  std::string name;         ///< unique, valid as a file name
  std::string config;       ///< the experiment as YAML, with absolute paths
  std::string fingerprint;  ///< of all that its result depends on, wherever the files are: a result of another one does
                            ///< not count
};

}  // namespace shellmatch
