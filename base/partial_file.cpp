#include "base/partial_file.h"

#include "base/error.h"

#include <fcntl.h>
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

constexpr std::string_view partial_infix = ".partial-";
constexpr std::size_t n_random_digits = 16;
constexpr std::size_t longest_stem = 190;  // file systems take names of 255 bytes

// What the names for `path` begin with. Of long names the end is left out: leftovers of other names that begin in the same way
// are removed as well, unless they are locked.
std::string beginning(const fs::path& path) { return "." + path.filename().string().substr(0, longest_stem) + std::string(partial_infix); }

bool has_lock(int file) {
  while (::flock(file, LOCK_EX | LOCK_NB) != 0)
    if (errno != EINTR) return false;
  return true;
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
    const int file = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    struct stat status {};
    if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && has_lock(file)) ::unlink(name.c_str());
    ::close(file);
  }
}

// Whether a file that was just created is still there: before it was locked, another process may have taken it for a leftover.
bool is_safe(int file) {
  while (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return false;
    if (errno != EINTR) return true;  // there are no locks, and leftovers stay
  }
  struct stat status {};
  return ::fstat(file, &status) != 0 || status.st_nlink > 0;
}

}  // namespace

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
    name_ = (place.parent_path() / fmt::format("{}{:08x}{:08x}{}", beginning(place), random(), random(), extension)).string();
    file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file_ < 0 && ((errno != EEXIST && errno != EINTR) || attempt > 100))
      throw_environment_error("{}: cannot be written ({}); check the folder, its permissions and the free space", path, std::strerror(errno));
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

}  // namespace shellmatch
