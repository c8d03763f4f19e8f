#pragma once
/// \file
/// A file in memory, for readers that take a path.

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch::fuzz {

class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : fd_(memfd_create("input", MFD_CLOEXEC)) {
    if (fd_ < 0 || write(fd_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) std::abort();
  }
  ~MemoryFile() { close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return fmt::format("/proc/self/fd/{}", fd_); }

 private:
  int fd_;
};

/// The same with an ending, by which readers choose a format: a link in the folder of temporary files while it lives.
class NamedMemoryFile {
 public:
  NamedMemoryFile(std::string_view bytes, std::string_view ending)
      : file_(bytes),
        link_(fmt::format("{}/shellmatch-fuzz-{}-{}{}", std::filesystem::temp_directory_path().string(), getpid(),
                          file_.path().substr(file_.path().rfind('/') + 1), ending)) {
    unlink(link_.c_str());  // left by a process of this number that crashed
    if (symlink(file_.path().c_str(), link_.c_str()) != 0) std::abort();
  }
  ~NamedMemoryFile() { unlink(link_.c_str()); }
  NamedMemoryFile(const NamedMemoryFile&) = delete;
  NamedMemoryFile& operator=(const NamedMemoryFile&) = delete;
  const std::string& path() const { return link_; }

 private:
  MemoryFile file_;
  std::string link_;
};

/// The parts of an input between its separators; at least one.
inline std::vector<std::string_view> parts_of(std::string_view bytes, char between) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = bytes.find(between);
    parts.push_back(bytes.substr(0, end));
    if (end == bytes.npos) return parts;
    bytes.remove_prefix(end + 1);
  }
}

}  // namespace shellmatch::fuzz
