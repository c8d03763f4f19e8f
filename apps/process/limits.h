#pragma once
/// \file
/// The limits of time and memory that a user sets to one command, kept by the program itself.

#include "base/stop.h"

#include <cstdint>
#include <string>

namespace shellmatch {

/// As on the command line; an empty text is no limit.
struct Limits {
  std::string seconds;  ///< wall time of the command, as "600"
  std::string memory;   ///< resident memory, as "800MB" or "4GB"
};

/// The bytes that "800MB" or "4GB" stand for (decimal units); 0 for an empty text. \throws InputError
std::uint64_t parse_memory(const std::string& text);
/// The seconds that a text such as "600" or "0.5" stands for; 0 for an empty text. \throws InputError
double parse_seconds(const std::string& text);

/// Why loops are to stop: a signal (apps/process/interrupt.h), or a limit that KeptLimits found exceeded.
StopCause stop_cause();

/// Keeps the limits of one command, of which there is one in a process, while it lives: parallel loops end with Stopped
/// (base/stop.h) once a limit is exceeded or a signal has come. Resident memory is looked at every hundredth of a
/// second; estimates (matching/cascade/level_memory.h) end a matching before a level that would exceed it.
class KeptLimits {
 public:
  /// What the limit of memory holds for.
  enum class Memory {
    of_process,  ///< this process; allocations far beyond the limit fail (std::bad_alloc)
    of_runs      ///< all runs of a study together, each of which is a process of its own
  };

  /// \throws InputError for texts that are no limit
  KeptLimits(const Limits& limits, Memory memory);
  ~KeptLimits();
  KeptLimits(const KeptLimits&) = delete;
  KeptLimits& operator=(const KeptLimits&) = delete;

  /// "--max-seconds 10 is over", for a message. \pre the cause is one of the limits
  std::string text(StopCause cause) const;

 private:
  Limits limits_;
};

}  // namespace shellmatch
