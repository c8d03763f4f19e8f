#include "base/replace_file.h"

#include "base/error.h"
#include "base/partial_file.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace shellmatch {

namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw_environment_error("{}: cannot be written ({}); check the folder, its permissions and the free space", path,
                          std::strerror(error));
}

// Calls again what a signal has interrupted, as it may on network file systems. \return 0, or the system's error number
template <class Call>
int error_of(Call&& call) {
  while (call() < 0)
    if (errno != EINTR) return errno;
  return 0;
}

bool is_folder(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

// Whether a file system or kernel says so that it has no such call.
bool is_missing(int error) { return error == EINVAL || error == ENOSYS || error == EOPNOTSUPP || error == EPERM; }

}  // namespace

int write_bytes(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

int synchronise(const std::string& path) {
  int descriptor = -1;
  if (const int error = error_of([&] { return descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC); }); error != 0) return error;
  // With delayed allocation, a full disk may be reported only here.
  const int error = error_of([&] { return ::fsync(descriptor); });
  ::close(descriptor);
  return error == EINVAL || error == EROFS ? 0 : error;
}

int rename_to_new(const std::string& from, const std::string& to) {
  int error = error_of([&] { return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE); });
  if (!is_missing(error)) return error;
  const bool folder = is_folder(from);
  if (!folder) {
    error = error_of([&] { return ::link(from.c_str(), to.c_str()); });
    if (error == 0) ::unlink(from.c_str());
    if (!is_missing(error)) return error;
  }
  int file = -1;
  error = error_of([&] { return folder ? ::mkdir(to.c_str(), 0777) : file = ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
  if (error != 0) return error;
  if (file >= 0) ::close(file);
  error = error_of([&] { return ::rename(from.c_str(), to.c_str()); });
  if (error != 0) folder ? ::rmdir(to.c_str()) : ::unlink(to.c_str());
  return error;
}

void publish_file(const std::string& path, Existing existing, const std::function<void(const std::string&)>& write) {
  PartialFile partial(path);
  write(partial.name());
  // Otherwise the new name could be on the disk before the contents are.
  if (const int error = synchronise(partial.name()); error != 0) fail(path, error);
  const int error = existing == Existing::is_kept ? rename_to_new(partial.name(), path)
                                                  : error_of([&] { return ::rename(partial.name().c_str(), path.c_str()); });
  if (error == EEXIST && existing == Existing::is_kept)
    throw_input_error("{}: exists by now, made by another program, and is not replaced; choose another name or give --force", path);
  if (error != 0) fail(path, error);
  partial.keep();
}

void publish_file(const std::string& path, Existing existing, std::string_view bytes) {
  publish_file(path, existing, [&](const std::string& partial) {
    int file = -1;
    int error = error_of([&] { return file = ::open(partial.c_str(), O_WRONLY | O_TRUNC | O_NOFOLLOW | O_CLOEXEC); });
    if (error == 0) error = write_bytes(file, bytes);
    // Where a signal interrupts it, the file is closed all the same.
    if (file >= 0 && ::close(file) != 0 && errno != EINTR && error == 0) error = errno;
    if (error != 0) fail(path, error);
  });
}

}  // namespace shellmatch
