#include "matching/output/file_lock.h"

#include "base/error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace shellmatch {

namespace {

// Calls again what a signal has interrupted, as it may on network file systems.
template <class Call>
int uninterrupted(Call&& call) {
  int result = -1;
  while ((result = call()) < 0 && errno == EINTR) {
  }
  return result;
}

// The previous holder of the lock may have removed the file after it was opened here.
bool is_file_at(int file, const std::string& path) {
  struct stat here {
  }, there{};
  return fstat(file, &here) == 0 && lstat(path.c_str(), &there) == 0 && here.st_ino == there.st_ino &&
         here.st_dev == there.st_dev;
}

}  // namespace

FileLock::FileLock(const std::string& path, Kind kind) : path_(path), kind_(kind) {
  for (;;) {
    // Following a link would create its target.
    constexpr int flags = O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    file_ = uninterrupted([&] { return open(path.c_str(), flags | O_EXCL, 0666); });
    is_own_ = file_ >= 0;
    if (file_ < 0 && errno == EEXIST) file_ = uninterrupted([&] { return open(path.c_str(), flags, 0666); });
    if (file_ < 0)
      throw_environment_error(
          "{}: {}", path,
          errno == ELOOP
              ? "is a link, but the lock of a run must be a file; remove the link"
              : fmt::format("cannot be written ({}); choose a folder you may write to with -o", std::strerror(errno)));
    if (uninterrupted([&] { return flock(file_, (kind == Kind::exclusive ? LOCK_EX : LOCK_SH) | LOCK_NB); }) != 0) {
      state_ = errno == EWOULDBLOCK ? State::taken : State::unsupported;
      return;
    }
    if (is_file_at(file_, path)) break;
    close(file_);
  }
  state_ = State::held;
}

FileLock::~FileLock() {
  // If the file has been removed, the name may belong to another process' lock; it is removed only if it is ours. Where
  // there are no locks, who created the file removes it.
  const bool is_ours = state_ == State::held ? kind_ == Kind::exclusive : state_ == State::unsupported && is_own_;
  if (is_ours && is_file_at(file_, path_)) unlink(path_.c_str());
  close(file_);
}

}  // namespace shellmatch
