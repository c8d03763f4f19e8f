#pragma once
/// \file
/// The folder that a run writes: all of it appears at once, or nothing.

#include "matching/output/file_lock.h"

#include <optional>
#include <string>
#include <string_view>

namespace shellmatch {

/// Files are written into a hidden folder beside the final one, on the same file system, and the folder is
/// renamed when all of it is there. A run that fails leaves what was there before, and nothing else. A run that is
/// killed leaves the hidden folder, `.NAME.partial-PID`, and a lock, `.NAME.lock`, which tells that nobody works on
/// it any more: the next one of that name removes both.
class OutputFolder {
 public:
  /// \param path the final folder; its parents are created where they are missing
  /// \param force replace a folder that an earlier run wrote; it stays untouched until commit()
  /// \throws InputError if `path` is a file, or a folder that is not empty and `force` is false, or one that
  ///   does not look like the output of a run or holds anything else beside it, or if another
  ///   process is writing to that name;
  ///   EnvironmentError if nothing can be written there
  OutputFolder(const std::string& path, bool force);
  /// Without commit() before, removes the hidden folder and the parents that were created.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write the file `name`, as "summary.json" or "pictures/result.png"; its folder is created.
  /// \throws EnvironmentError if it cannot be created
  std::string path_of(std::string_view name);

  /// The final folder, absolute.
  const std::string& final_path() const { return final_; }

  /// Brings everything to the disk and puts the folder in its place. \throws EnvironmentError where the disk
  /// does not take it; the destructor then cleans up. InputError if somebody else filled the place meanwhile.
  void commit();

 private:
  void remove_created_parents() noexcept;

  std::string final_, partial_, first_created_parent_;
  bool force_, committed_ = false;
  std::optional<FileLock> lock_;
};

}  // namespace shellmatch
