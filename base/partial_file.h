#pragma once
/// \file
/// Files under hidden names, in which new contents are prepared (base/replace_file.h).

#include <string>
#include <string_view>

namespace shellmatch {

/// Whether a file of this name may have been left by a process that was killed while it wrote: `.NAME.partial-RANDOM.EXTENSION`.
bool is_partial_file_name(std::string_view name);

/// An empty file in the folder of `path`, with such a name that nothing had before: no link is followed and no file is lost.
/// Its extension is that of `path`, for writers that go by it. It is locked while this object lives, and removed at its end.
class PartialFile {
 public:
  /// Removes in addition what killed processes have left of `path`: files of such names that nobody has locked.
  /// \throws EnvironmentError naming `path`
  explicit PartialFile(const std::string& path);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  const std::string& name() const { return name_; }

  /// The file has got another name, and stays.
  void keep() { is_kept_ = true; }

 private:
  std::string name_;
  int file_ = -1;
  bool is_kept_ = false;
};

}  // namespace shellmatch
