#pragma once
/// \file
/// Runs a study: every run in a process and a folder of its own, those that have a result already left out.

#include "matching/output/file_lock.h"
#include "studies/execution/run_result.h"
#include "studies/study.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// How a study is run, besides what its file says.
struct StudySettings {
  std::string program;  ///< executable that is run as `PROGRAM run CONFIG -o DIR`; empty for this one
  int jobs = 1;         ///< runs at the same time
  bool retry = false;   ///< run again what has not finished
};

/// What wants to know how a study goes on.
class StudyObserver {
 public:
  virtual ~StudyObserver() = default;
  virtual void run_started(const StudyRun& /*run*/) {}
  virtual void run_ended(const StudyRun& /*run*/, const RunResult& /*result*/) {}
  /// Asked about fifty times a second. True ends the processes that are under way; what they did is lost.
  virtual bool stop_requested() { return false; }
};

/// Begins the name of a file of a study that is being written, beside its place.
inline constexpr std::string_view partial_file_prefix = ".partial-";

/// A folder that studies are written to. It holds study.yaml and runs/NAME/ with config.yaml, log.txt,
/// output/ and result.json; collect() adds the tables.
class StudyFolder {
 public:
  /// Creates the folder, or takes the one of an earlier start of a study, and locks it: several processes may
  /// work on single runs of one study, but only one on the whole of it. \throws InputError if it holds
  /// anything else or if another process works there, EnvironmentError if it
  ///   cannot be written
  /// \param whole_study removes what killed processes have left in the folder, as remove_leftovers()
  StudyFolder(const std::string& path, bool whole_study);
  StudyFolder(const StudyFolder&) = delete;
  StudyFolder& operator=(const StudyFolder&) = delete;

  const std::string& path() const { return path_; }
  bool is_whole() const { return whole_study_; }
  std::string run_folder(const StudyRun& run) const { return path_ + "/runs/" + run.name; }

  /// The result of that run; not_run where there is none or where it is that of another configuration.
  RunResult result_of(const StudyRun& run) const;

  /// Removes locks that nobody holds, and half-written runs and tables; nothing where other processes may be at work.
  void remove_leftovers() const;

 private:
  std::string path_;
  bool whole_study_;
  FileLock lock_;
};

/// Runs those of `runs` that have no result yet, in their order. A time-out or want of memory counts as a
/// result as long as the limits have not been raised since. Returns false where the observer stopped it.
/// \throws EnvironmentError if no process can be started or nothing can be written
bool run_study(const Study& study, const std::vector<StudyRun>& runs, const StudyFolder& folder,
               const StudySettings& settings, StudyObserver& observer);

}  // namespace shellmatch
