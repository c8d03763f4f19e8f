#pragma once
/// \file
/// A file in memory, for readers that take a path.

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
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
