#pragma once
/// \file
/// What the commands share that perform many runs: their settings and their progress.

#include "apps/studies/execution/run_tasks.h"

#include <chrono>
#include <cstddef>
#include <string>

namespace shellmatch {

/// Empty where the file cannot be read.
std::string contents_of(const std::string& file);

/// \throws InputError if the file exists, says something else than `text`, and is no copy of ours: it is somebody's
void check_copy_place(const std::string& path, const std::string& text);

/// Writes the text, with a last line by which the copy is known; a file of the user's that says the same stays.
/// \throws InputError as check_copy_place(), EnvironmentError if it cannot be written
void keep_copy(const std::string& path, const std::string& text);

/// Progress of many runs, a line for each, on the standard error.
class RunsProgress : public virtual TaskObserver {
 public:
  explicit RunsProgress(bool is_quiet) : is_quiet_(is_quiet) {}
  void run_started(const RunTask& run) override;
  void run_ended(const RunTask& run, const RunResult& result) override;
  bool stop_requested() override;
  void say(const std::string& text) const;

  void runs_begin(std::size_t n_runs) override;

 private:
  // "3 of 12", and the time that the others will take if they take as long as those before, as many at a time.
  std::string place() const;

  bool is_quiet_;
  std::size_t n_runs_ = 0, n_ended_ = 0;
  std::chrono::steady_clock::time_point begin_;
};

/// The value of --jobs; `fallback` where it is not given. \throws InputError
int number_of_jobs(const std::string& text, int fallback);

/// The absolute path of another executable, checked to be one that execv accepts; empty for an empty one.
/// \throws InputError
std::string checked_program(const std::string& program);

/// All runs at a time share the memory that the user has given.
void keep_memory_of_runs(RunLimits& limits, int jobs);

}  // namespace shellmatch
