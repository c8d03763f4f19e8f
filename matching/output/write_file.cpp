#include "matching/output/write_file.h"

#include "base/error.h"
#include "base/replace_file.h"

#include <fcntl.h>
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

}  // namespace shellmatch
