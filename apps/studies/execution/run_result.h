#pragma once
/// \file
/// The result of one run of a study: the file result.json in its folder, which marks the run as done.

#include <cstdint>
#include <optional>
#include <string>

namespace shellmatch {

/// finished: ended regularly; diverged: likewise, but without a finite energy or a valid start; failed: ended with an
/// error message; crashed: ended by a signal; timed_out, out_of_memory: ended for exceeding a limit; not_run: no result
/// yet.
enum class RunStatus { finished, diverged, failed, crashed, timed_out, out_of_memory, not_run };

std::string status_name(RunStatus status);

struct RunResult {
  RunStatus status = RunStatus::not_run;
  std::string message;  ///< error message, unless it finished
  int exit_code = 0, signal = 0;
  std::string fingerprint;  ///< RunTask::fingerprint of the run
  double seconds = 0;       ///< wall time of the process
  std::uint64_t peak_memory_bytes = 0;
  double limit_seconds = 0, limit_memory_mb = 0;  ///< limits that were in force; 0 means none
  int jobs = 1;                                   ///< number of runs allowed at the same time
  double load = 0;                                ///< load average of the last minute when the run began
  std::string machine;                            ///< processor, cores, memory
  std::string program;                            ///< version of the program that was run
};

/// \throws EnvironmentError if the file cannot be written
void write_run_result(const RunResult& result, const std::string& path);

/// Reads a result; nothing if the file is missing or damaged.
std::optional<RunResult> read_run_result(const std::string& path);

}  // namespace shellmatch
