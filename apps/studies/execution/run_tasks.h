#pragma once
/// \file
/// Runs of the program, each in its own process and folder; runs with a result are skipped. Studies and cohorts are
/// made of them.

#include "apps/studies/execution/run_result.h"
#include "apps/studies/execution/run_task.h"
#include "apps/studies/execution/runs_folder.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// How runs are executed.
struct TaskSettings {
  std::string program;  ///< executable, called as `PROGRAM run CONFIG -o DIR`; empty for this one
  int jobs = 1;         ///< number of runs at the same time
  bool retry = false;   ///< repeat runs that did not finish
};

/// Receives the progress of many runs.
class TaskObserver {
 public:
  virtual ~TaskObserver() = default;
  virtual void runs_begin(std::size_t /*n_runs*/) {}  ///< how many will be performed, as they have no result yet
  virtual void run_started(const RunTask& /*run*/) {}
  virtual void run_ended(const RunTask& /*run*/, const RunResult& /*result*/) {}
  /// Called about a hundred times a second. Returning true ends the processes in progress; their results are discarded.
  virtual bool stop_requested() { return false; }
};

/// Performs those of `runs` that have no result yet, in their order. A run that exceeded a limit is repeated only if
/// that limit has been raised. Returns false if the observer stopped it.
/// \throws EnvironmentError if no process can be started or nothing can be written, also by a run: the disk is full
bool run_tasks(const std::vector<const RunTask*>& runs, const RunLimits& limits, const RunsFolder& folder,
               const TaskSettings& settings, TaskObserver& observer);

/// Pointers to runs that derive from RunTask.
template <class Run>
std::vector<const RunTask*> tasks_of(const std::vector<Run>& runs) {
  std::vector<const RunTask*> tasks;
  for (const Run& run : runs) tasks.push_back(&run);
  return tasks;
}

}  // namespace shellmatch
