#include "matching/output/write_file.h"

#include "base/error.h"
#include "base/replace_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace shellmatch {

void cannot_write(const std::string& path, int error) {
  const bool is_full = error == ENOSPC || error == EDQUOT;
  cannot_be_written(error, fmt::format("{}: cannot be written ({}); {}", path, std::strerror(error),
                                       is_full ? "make room on the disk or choose another folder with -o"
                                               : "choose a folder you may write to with -o"));
}

void synchronise_file(const std::string& path) {
  if (const int error = synchronise(path); error != 0) cannot_write(path, error);
}

void write_file(const std::string& path, std::string_view contents) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  int error = file < 0 ? errno : write_bytes(file, contents);
  if (file >= 0 && ::close(file) != 0 && error == 0) error = errno;
  if (error != 0) cannot_write(path, error);
}

bool is_mount_point(const std::filesystem::path& folder) {
  struct statx found {};
  if (::statx(AT_FDCWD, folder.c_str(), 0, STATX_BASIC_STATS, &found) != 0) return false;
  if ((found.stx_attributes_mask & STATX_ATTR_MOUNT_ROOT) != 0)
    return (found.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
  struct statx above {};
  return ::statx(AT_FDCWD, folder.parent_path().c_str(), 0, STATX_BASIC_STATS, &above) == 0 &&
         (found.stx_dev_major != above.stx_dev_major || found.stx_dev_minor != above.stx_dev_minor);
}

}  // namespace shellmatch
