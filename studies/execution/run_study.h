#pragma once
/// \file
/// Runs a study: each run in its own process and folder; runs with a result are skipped.

#include "matching/output/file_lock.h"
#include "studies/execution/run_result.h"
#include "studies/study.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// Settings of a study's execution, in addition to those of its file.
struct StudySettings {
  std::string program;  ///< executable, called as `PROGRAM run CONFIG -o DIR`; empty for this one
  int jobs = 1;         ///< number of runs at the same time
  bool retry = false;   ///< repeat runs that did not finish
};

/// Receives the progress of a study.
class StudyObserver {
 public:
  virtual ~StudyObserver() = default;
  virtual void run_started(const StudyRun& /*run*/) {}
  virtual void run_ended(const StudyRun& /*run*/, const RunResult& /*result*/) {}
  /// Called about fifty times a second. Returning true ends the processes in progress; their results are discarded.
  virtual bool stop_requested() { return false; }
};

/// The output folder of a study. It holds study.yaml and runs/NAME/ with config.yaml, log.txt, output/ and result.json;
/// collect_study() adds the tables.
class StudyFolder {
 public:
  /// Creates the folder, or opens that of an earlier start of the study, and locks it: several processes may perform
  /// single runs of one study, but only one the whole of it.
  /// \param whole_study locks exclusively, and removes what killed processes have left, as remove_leftovers()
  /// \throws InputError if the folder holds anything else or another process has locked it, EnvironmentError if it
  ///   cannot be written
  StudyFolder(const std::string& path, bool whole_study);
  StudyFolder(const StudyFolder&) = delete;
  StudyFolder& operator=(const StudyFolder&) = delete;

  const std::string& path() const { return path_; }
  bool is_whole() const { return whole_study_; }
  std::string run_folder(const StudyRun& run) const { return path_ + "/runs/" + run.name; }

  /// The result of the run; not_run if there is none or it belongs to another configuration.
  RunResult result_of(const StudyRun& run) const;

  /// Removes unheld locks, incomplete runs and incomplete tables. Does nothing if other processes may work in the
  /// folder.
  void remove_leftovers() const;

 private:
  std::string path_;
  bool whole_study_;
  FileLock lock_;
};

/// Performs those of `runs` that have no result yet, in their order. A run that exceeded a limit is repeated only if
/// that limit has been raised. Returns false if the observer stopped it.
/// \throws EnvironmentError if no process can be started or nothing can be written
bool run_study(const Study& study, const std::vector<StudyRun>& runs, const StudyFolder& folder,
               const StudySettings& settings, StudyObserver& observer);

}  // namespace shellmatch
