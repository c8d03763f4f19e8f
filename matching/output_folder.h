#pragma once
/// \file
/// The folder that a run writes: all of it appears at once, or nothing.

#include <string>
#include <string_view>

namespace shellmatch {

/// Files are written into a hidden folder beside the final one, on the same file system, and the folder is
/// renamed when all of it is there. A run that fails leaves what was there before, and nothing else; a run
/// that is killed may leave the hidden folder, `.NAME.partial-PID`, which may be deleted.
class OutputFolder {
 public:
  /// \param path the final folder; its parents are created where they are missing
  /// \param force replace a folder that an earlier run wrote; it stays untouched until commit()
  /// \throws InputError if `path` is a file, or a folder that is not empty and `force` is false, or one that
  ///   does not look like the output of a run (nobody's home folder is replaced by mistake);
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

  /// For a run that was interrupted: if anything has been written it is committed, files that are empty left
  /// out; returns whether there was anything. The caller sees to it that each file is whole.
  bool keep_partial();

 private:
  void remove_created_parents() noexcept;

  std::string final_, partial_, first_created_parent_;
  bool force_, committed_ = false;
};

/// Writes a whole file. \throws EnvironmentError naming the file: disk full, no permission.
void write_file(const std::string& path, std::string_view contents);

}  // namespace shellmatch
