#include "base/replace_file.h"

#include "base/error.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>
#include <vector>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  cannot_be_written(
      error, fmt::format("{}: cannot be written ({}); check the folder, its permissions and the free space", path,
                         std::strerror(error)));
}

// Calls again what a signal has interrupted, as it may on network file systems. \return 0, or the system's error number
template <class Call>
int error_of(Call&& call) {
  while (call() < 0)
    if (errno != EINTR) return errno;
  return 0;
}

constexpr std::string_view partial_infix = ".partial-";
constexpr std::size_t n_random_digits = 16;
constexpr std::size_t longest_stem = 190;  // file systems take names of 255 bytes

// What the names for `path` begin with. Of long names the end is left out: leftovers of other names that begin in the
// same way are removed as well, unless they are locked.
std::string beginning(const fs::path& path) {
  return "." + path.filename().string().substr(0, longest_stem) + std::string(partial_infix);
}

int lock(int file) {
  return error_of([&] { return ::flock(file, LOCK_EX | LOCK_NB); });
}

void remove_leftovers_of(const fs::path& path) {
  std::error_code error;
  std::vector<std::string> found;
  const std::string begin = beginning(path);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  for (auto at = fs::directory_iterator(folder, error); !error && at != fs::end(at); at.increment(error))
    if (const std::string name = at->path().filename().string(); name.starts_with(begin) && is_partial_file_name(name))
      found.push_back(at->path().string());
  for (const std::string& name : found) {
    // Network file systems lock exclusively only what is open for writing.
    const int file = ::open(name.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    struct stat status {};
    if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && lock(file) == 0) ::unlink(name.c_str());
    ::close(file);
  }
}

// Whether a file that was just created is still there: before it was locked, another process may have taken it for a
// leftover.
bool is_safe(int file) {
  if (const int error = lock(file); error != 0) return error != EWOULDBLOCK;  // there are no locks, and leftovers stay
  struct stat status {};
  return ::fstat(file, &status) != 0 || status.st_nlink > 0;
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
  if (const int error = error_of([&] { return descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC); }); error != 0)
    return error;
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
  error = error_of([&] {
    return folder ? ::mkdir(to.c_str(), 0777)
                  : file = ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  });
  if (error != 0) return error;
  if (file >= 0) ::close(file);
  error = error_of([&] { return ::rename(from.c_str(), to.c_str()); });
  if (error != 0) folder ? ::rmdir(to.c_str()) : ::unlink(to.c_str());
  return error;
}

bool is_partial_file_name(std::string_view name) {
  const std::size_t infix = name.rfind(partial_infix);
  if (!name.starts_with('.') || infix == name.npos) return false;
  name.remove_prefix(infix + partial_infix.size());
  const std::size_t n = std::min(name.find_first_not_of("0123456789abcdef"), name.size());
  return n == n_random_digits && (name.size() == n || name[n] == '.');
}

PartialFile::PartialFile(const std::string& path) {
  const fs::path place = path;
  remove_leftovers_of(place);
  // A long extension is none that a writer asks for; without it the name fits every file system.
  std::string extension = place.extension().string();
  if (extension.size() > 16) extension.clear();
  std::random_device random;
  for (int attempt = 0; file_ < 0; ++attempt) {
    name_ = (place.parent_path() / fmt::format("{}{:08x}{:08x}{}", beginning(place), random(), random(), extension))
                .string();
    file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file_ < 0 && ((errno != EEXIST && errno != EINTR) || attempt > 100)) fail(path, errno);
    if (file_ >= 0 && !is_safe(file_)) {
      ::unlink(name_.c_str());
      ::close(std::exchange(file_, -1));
    }
  }
}

PartialFile::~PartialFile() {
  if (!is_kept_) ::unlink(name_.c_str());
  ::close(file_);
}

PendingFile::PendingFile(std::string path, Existing existing, const std::function<void(const std::string&)>& write)
    : path_(std::move(path)), existing_(existing), partial_(std::make_unique<PartialFile>(path_)) {
  write(partial_->name());
  // Otherwise the new name could be on the disk before the contents are.
  if (const int error = synchronise(partial_->name()); error != 0) fail(path_, error);
}

PendingFile::PendingFile(std::string path, Existing existing, std::string_view bytes)
    : PendingFile(path, existing, [&](const std::string& partial) {
        int file = -1;
        int error =
            error_of([&] { return file = ::open(partial.c_str(), O_WRONLY | O_TRUNC | O_NOFOLLOW | O_CLOEXEC); });
        if (error == 0) error = write_bytes(file, bytes);
        // Where a signal interrupts it, the file is closed all the same.
        if (file >= 0 && ::close(file) != 0 && errno != EINTR && error == 0) error = errno;
        if (error != 0) fail(path, error);
      }) {}

void PendingFile::publish() {
  const std::string& from = partial_->name();
  const int error = existing_ == Existing::is_kept ? rename_to_new(from, path_)
                                                   : error_of([&] { return ::rename(from.c_str(), path_.c_str()); });
  if (error == EEXIST && existing_ == Existing::is_kept)
    throw_input_error(
        "{}: exists by now, made by another program, and is not replaced; choose another name or give --force", path_);
  if (error != 0) fail(path_, error);
  partial_->keep();
  is_published_ = true;
  // The file is whole in any case; that its new name is on the disk, too, is as much as can be done.
  const fs::path folder = fs::path(path_).parent_path();
  synchronise(folder.empty() ? "." : folder.string());
}

void PendingFile::withdraw() noexcept {
  if (is_published_ && existing_ == Existing::is_kept) ::unlink(path_.c_str());
}

void publish_together(std::span<PendingFile> files) {
  try {
    for (PendingFile& file : files) file.publish();
  } catch (...) {
    for (PendingFile& file : files) file.withdraw();
    throw;
  }
}

void publish_file(const std::string& path, Existing existing, const std::function<void(const std::string&)>& write) {
  PendingFile(path, existing, write).publish();
}

void publish_file(const std::string& path, Existing existing, std::string_view bytes) {
  PendingFile(path, existing, bytes).publish();
}

}  // namespace shellmatch
