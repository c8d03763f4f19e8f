#pragma once
/// \file
/// The output folder of a run, which is written completely or not at all.

#include "matching/output/file_lock.h"

#include <optional>
#include <string>
#include <string_view>

namespace shellmatch {

/// Files are written to a hidden folder beside the final one, on the same file system; commit() renames it. A run that
/// fails leaves the earlier contents unchanged. A run that is killed leaves the hidden folder `.NAME.partial-PID` and a
/// lock file `.NAME.lock` that nobody holds; the next run for the same output removes both.
class OutputFolder {
 public:
  /// \param path the final folder; missing parents are created
  /// \param force replace a folder that an earlier run wrote; it stays untouched until commit()
  /// \throws InputError if `path` is a file, or a folder that is not empty and `force` is false, or one that
  ///   does not look like the output of a run or holds anything else beside it, or if another
  ///   process is writing to that name;
  ///   EnvironmentError if nothing can be written there
  OutputFolder(const std::string& path, bool force);
  /// Without commit(), removes the hidden folder and the parents that were created.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The path at which to write the file `name`, as "summary.json" or "pictures/result.png"; creates its folder.
  /// \throws EnvironmentError if it cannot be created
  std::string path_of(std::string_view name);

  /// The absolute path of the final folder.
  const std::string& final_path() const { return final_; }

  /// Flushes everything to the disk and renames the folder. \throws EnvironmentError if writing fails; the destructor
  /// then cleans up. InputError if the final folder has been filled in the meantime
  void commit();

 private:
  void remove_created_parents() noexcept;

  std::string final_, partial_, first_created_parent_;
  bool force_, committed_ = false;
  std::optional<FileLock> lock_;
};

}  // namespace shellmatch
