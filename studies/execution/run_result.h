#pragma once
/// \file
/// What came of one run of a study: the file result.json in its folder, by which a finished run is known.

#include <cstdint>
#include <optional>
#include <string>

namespace shellmatch {

/// finished: went to its end; diverged: so too, but without a finite energy or a start that can be evaluated;
/// failed: ended with an error of its own; crashed: ended by a signal; timed_out, out_of_memory: ended for
/// exceeding a limit; not_run: no result yet.
enum class RunStatus { finished, diverged, failed, crashed, timed_out, out_of_memory, not_run };

std::string status_name(RunStatus status);

struct RunResult {
  RunStatus status = RunStatus::not_run;
  std::string message;  ///< of the program, where it did not finish
  int exit_code = 0, signal = 0;
  std::string fingerprint;  ///< StudyRun::fingerprint of the run that this is the result of
  double seconds = 0;       ///< wall time of the process
  std::uint64_t peak_memory_bytes = 0;
  double limit_seconds = 0, limit_memory_mb = 0;  ///< under which it ran; 0 means none
  int jobs = 1;                                   ///< runs that were allowed at the same time
  double load = 0;      ///< processes that wanted to run on the machine when it began (mean of one minute)
  std::string machine;  ///< processor, cores, memory
  std::string program;  ///< version of the program that was run
};

/// \throws EnvironmentError if the file cannot be written
void write_run_result(const RunResult& result, const std::string& path);

/// Nothing where there is no such file or it is damaged: then there is no result.
std::optional<RunResult> read_run_result(const std::string& path);

}  // namespace shellmatch
