#pragma once
/// \file
/// Writes files so that a reader sees the old contents or the new, never a part, also after a power cut.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace shellmatch {

/// Writes all bytes through a file descriptor. \return 0, or the system's error number
int write_bytes(int descriptor, std::string_view bytes);

/// Waits until the file's contents, or the folder's entries, are on the disk. File systems that cannot say so count as
/// done. \return 0, or the system's error number
int synchronise(const std::string& path);

/// Renames a file or folder to a name that is free. A name that is taken, be it by a link that leads nowhere, stays
/// what it is, also if it came into being a moment ago. On file systems that have neither such a rename nor hard links
/// the name is taken by an empty file or folder first, which remains if the process is killed there. \return 0, EEXIST
/// if the name is taken, or another of the system's error numbers
int rename_to_new(const std::string& from, const std::string& to);

/// Whether a file of this name may have been left by a process that was killed while it wrote:
/// `.NAME.partial-RANDOM.EXTENSION`.
bool is_partial_file_name(std::string_view name);

/// An empty file in the folder of `path`, with such a name that nothing had before: no link is followed and no file is
/// lost. Its extension is that of `path`, for writers that go by it. It is locked while this object lives, and removed
/// at its end.
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

/// What becomes of a file that has the name.
enum class Existing { is_replaced, is_kept };

/// A file that is whole and on the disk, but has not got its name yet. It is removed at the end of this object unless
/// it is published.
class PendingFile {
 public:
  /// Calls `write` with the name of a file beside `path` (PartialFile).
  /// \throws EnvironmentError if the file cannot be created, and whatever `write` throws; nothing is left then
  PendingFile(std::string path, Existing existing, const std::function<void(const std::string&)>& write);

  /// The same with these contents. \throws EnvironmentError naming `path`: disk full, no permission
  PendingFile(std::string path, Existing existing, std::string_view bytes);

  /// Renames it to its path. \throws InputError if the name is taken and what has it is kept, EnvironmentError if it
  /// cannot be renamed
  void publish();

  /// Removes it again if it has been published under a name that was free.
  void withdraw() noexcept;

 private:
  std::string path_;
  Existing existing_;
  std::unique_ptr<PartialFile> partial_;
  bool is_published_ = false;
};

/// Publishes all or, as far as names were free, none: what was published before the first failure is withdrawn. \throws
/// as PendingFile::publish
void publish_together(std::span<PendingFile> files);

/// Calls `write` with the name of a file beside `path` (PartialFile) and renames it to `path`.
/// \throws InputError if the name is taken and what has it is kept, EnvironmentError if the file cannot be created or
/// renamed, and whatever `write` throws; nothing is left then
void publish_file(const std::string& path, Existing existing, const std::function<void(const std::string&)>& write);

/// The same with these contents. \throws EnvironmentError naming `path`: disk full, no permission
void publish_file(const std::string& path, Existing existing, std::string_view bytes);

/// publish_file() where what has the name is replaced.
inline void replace_file(const std::string& path, std::string_view bytes) {
  publish_file(path, Existing::is_replaced, bytes);
}
inline void replace_file(const std::string& path, const std::function<void(const std::string&)>& write) {
  publish_file(path, Existing::is_replaced, write);
}

}  // namespace shellmatch
