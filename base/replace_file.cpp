#include "base/replace_file.h"

#include "base/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view partial_file_prefix = ".partial-";
constexpr std::size_t n_random_digits = 16;

[[noreturn]] void fail(const std::string& path, int error) {
  throw_environment_error("{}: cannot be written ({}); check the folder, its permissions and the free space", path,
                          std::strerror(error));
}

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
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  // With delayed allocation, a full disk may be reported only here.
  const int error = ::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS ? errno : 0;
  ::close(descriptor);
  return error;
}

bool is_partial_file_name(std::string_view name) {
  if (!name.starts_with(partial_file_prefix)) return false;
  name.remove_prefix(partial_file_prefix.size());
  const std::size_t n = std::min(name.find_first_not_of("0123456789abcdef"), name.size());
  return n == n_random_digits && (name.size() == n || name[n] == '.');
}

std::string create_partial_file(const std::string& path) {
  const fs::path place = path;
  // A long extension is none that a writer asks for; without it the name fits every file system.
  std::string extension = place.extension().string();
  if (extension.size() > 16) extension.clear();
  std::random_device random;
  for (int attempt = 0;; ++attempt) {
    const std::string name = fmt::format("{}{:08x}{:08x}{}", partial_file_prefix, random(), random(), extension);
    const std::string partial = (place.parent_path() / name).string();
    const int file = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file >= 0) {
      ::close(file);
      return partial;
    }
    if (errno != EEXIST || attempt > 100) fail(path, errno);
  }
}

void replace_file(const std::string& path, const std::function<void(const std::string&)>& write) {
  const std::string partial = create_partial_file(path);
  std::error_code error, ignored;
  try {
    write(partial);
    // Otherwise the new name could be on the disk before the contents are.
    if (const int cause = synchronise(partial); cause != 0) fail(path, cause);
    fs::rename(partial, path, error);
    if (error) fail(path, error.value());
  } catch (...) {
    fs::remove(partial, ignored);
    throw;
  }
}

void replace_file(const std::string& path, std::string_view bytes) {
  replace_file(path, [&](const std::string& partial) {
    const int file = ::open(partial.c_str(), O_WRONLY | O_TRUNC | O_NOFOLLOW | O_CLOEXEC);
    int cause = file < 0 ? errno : write_bytes(file, bytes);
    if (file >= 0 && ::close(file) != 0 && cause == 0) cause = errno;
    if (cause != 0) fail(path, cause);
  });
}

}  // namespace shellmatch
