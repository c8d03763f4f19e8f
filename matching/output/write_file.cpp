#include "matching/output/write_file.h"

#include "base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace shellmatch {

namespace {

// A file descriptor that is closed by its destructor.
class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

// With delayed allocation, a full disk may be reported only here.
void synchronise(const std::string& path, int flags) {
  Descriptor file(path, flags);
  if (file.get() < 0 || (::fsync(file.get()) != 0 && errno != EINVAL && errno != EROFS))
    cannot_write(path, errno);
}

}  // namespace

void cannot_write(const std::string& path, int error) {
  throw_environment_error("{}: cannot be written ({}); {}", path, std::strerror(error),
                          error == ENOSPC || error == EDQUOT
                              ? "make room on the disk or choose another folder with -o"
                              : "choose a folder you may write to with -o");
}

void synchronise_file(const std::string& path) { synchronise(path, O_RDONLY); }
void synchronise_folder(const std::string& path) { synchronise(path, O_RDONLY | O_DIRECTORY); }

void write_file(const std::string& path, std::string_view contents) {
  Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
  if (file.get() < 0) cannot_write(path, errno);
  while (!contents.empty()) {
    const ssize_t written = ::write(file.get(), contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) cannot_write(path, errno);
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  if (!file.close()) cannot_write(path, errno);
}

}  // namespace shellmatch
