#pragma once
/// \file
/// The output folder of a study or a cohort, which holds its runs.

#include "matching/output/file_lock.h"
#include "apps/studies/execution/run_result.h"
#include "apps/studies/execution/run_task.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// What a folder of runs belongs to, and what may be in it.
struct RunsFolderKind {
  std::string_view owner;                     ///< for messages: "study"
  std::vector<std::string_view> before_runs;  ///< names of its own that may be there before the folder `runs`
  std::vector<std::string_view> after_runs;   ///< names of its own that are there only beside it
  std::string_view files_folder;  ///< a folder of its own that holds files which are written one by one; may be empty
};

extern const RunsFolderKind study_folder_kind;

/// The output folder of a study or the like. It holds runs/NAME/ with config.yaml, log.txt, output/ and result.json,
/// and what its kind adds.
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

}  // namespace shellmatch
