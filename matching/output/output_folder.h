#pragma once
/// \file
/// The output folder of a run, which is written completely or not at all.

#include "matching/output/file_lock.h"
#include "matching/output/written_files.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace shellmatch {

/// \throws InputError if one of the files or folders `inputs` lies in the folder at `path`, which a run replaces: what
/// its result was made from would be gone. Names of nothing are passed over.
void check_inputs_outlive(const std::string& path, std::span<const std::string> inputs);

/// Files are written to a hidden folder beside the final one, on the same file system; commit() lists them in
/// files.json (matching/output/written_files.h) and renames the folder. A run that fails leaves the earlier contents
/// unchanged. A run that is killed leaves the hidden folder `.NAME.partial-PID` and a lock file `.NAME.lock` that
/// nobody holds; the next run for the same output removes both.
///
/// Where the final folder exists and cannot be renamed, being a mount point or in a folder that may not be written,
/// both are in it, and commit() moves the files one by one, files.json first.
class OutputFolder {
 public:
  /// \param path the final folder; missing parents are created
  /// \param force replace a folder that an earlier run wrote; it stays untouched until commit()
  /// \param changed whether a file of the earlier run that has changed since may be replaced
  /// \throws InputError if `path` is a file, or a folder that is not empty and `force` is false, or one that holds
  ///   anything that does not stand in its files.json, or if another process is writing to that name;
  ///   EnvironmentError if nothing can be written there
  OutputFolder(const std::string& path, bool force, ChangedFiles changed = ChangedFiles::are_foreign);
  /// Without commit(), removes the hidden folder and the parents that were created.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// The path at which to write the file `name`, as "summary.json" or "pictures/result.png"; creates its folder.
  /// \throws EnvironmentError if it cannot be created
  std::string path_of(std::string_view name);

  /// The absolute path of the final folder.
  const std::string& final_path() const { return final_; }

  /// Writes files.json, flushes everything to the disk and renames the folder. \throws EnvironmentError if writing
  /// fails; the destructor then cleans up. InputError if the final folder has been filled in the meantime
  void commit();

 private:
  void prepare(const std::string& anchor);
  void remove_created_parents() noexcept;
  void exchange();
  void fill_in_place();
  void remove_earlier(const std::string& folder);

  std::string final_, partial_, first_created_parent_;
  bool force_, in_place_ = false;
  bool committed_ = false;  ///< the result is in its place: partial_ holds what it has replaced, or nothing
  ChangedFiles changed_;
  std::optional<FileLock> lock_;
  std::unique_ptr<std::byte[]>
      reserve_;  ///< memory with which the destructor can list the hidden folder where there is no more
};

}  // namespace shellmatch
