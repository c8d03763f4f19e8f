#pragma once
/// \file
/// Runs of the program, each in its own process and folder; runs with a result are skipped. Studies and cohorts are made of them.

#include "matching/output/file_lock.h"
#include "studies/execution/run_limits.h"
#include "studies/execution/run_result.h"
#include "studies/execution/run_task.h"

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
  virtual void run_started(const RunTask& /*run*/) {}
  virtual void run_ended(const RunTask& /*run*/, const RunResult& /*result*/) {}
  /// Called about fifty times a second. Returning true ends the processes in progress; their results are discarded.
  virtual bool stop_requested() { return false; }
};

/// What a folder of runs belongs to, and what may be in it.
struct RunsFolderKind {
  std::string_view owner;  ///< for messages: "study"
  std::vector<std::string_view> before_runs;  ///< names of its own that may be there before the folder `runs`
  std::vector<std::string_view> after_runs;   ///< names of its own that are there only beside it
  std::string_view files_folder;              ///< a folder of its own that holds files which are written one by one; may be empty
};

extern const RunsFolderKind study_folder_kind;

/// The output folder of a study or the like. It holds runs/NAME/ with config.yaml, log.txt, output/ and result.json, and what its kind adds.
class RunsFolder {
 public:
  /// Creates the folder, or opens that of an earlier start, and locks it: several processes may perform
  /// single runs, but only one the whole.
  /// \param whole locks exclusively, and removes what killed processes have left, as remove_leftovers()
  /// \throws InputError if the folder holds anything else or another process has locked it, EnvironmentError if it
  ///   cannot be written
  RunsFolder(const std::string& path, const RunsFolderKind& kind, bool whole);
  RunsFolder(const RunsFolder&) = delete;
  RunsFolder& operator=(const RunsFolder&) = delete;

  const std::string& path() const { return path_; }
  bool is_whole() const { return whole_; }
  std::string run_folder(const RunTask& run) const { return path_ + "/runs/" + run.name; }

  /// The result of the run; not_run if there is none or it belongs to another configuration.
  RunResult result_of(const RunTask& run) const;

  /// Removes unheld locks, incomplete runs and incomplete tables. Does nothing if other processes may work in the
  /// folder.
  void remove_leftovers() const;

 private:
  std::string path_, files_folder_;
  bool whole_;
  FileLock lock_;
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
