#include "matching/progress/process_info.h"

#include "base/error.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>

namespace shellmatch {

namespace {

std::atomic<std::uint64_t> memory_limit = 0;

// The first number in a file, or `none` if there is none, as for "max" in a cgroup's limit.
std::uint64_t number_in(const char* path, std::uint64_t none) {
  std::ifstream in(path);
  std::uint64_t number;
  return in >> number ? number : none;
}

}  // namespace

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // in kilobytes on Linux
}

std::uint64_t resident_memory_bytes(const std::string& process) {
  std::ifstream statm(fmt::format("/proc/{}/statm", process));
  std::uint64_t all = 0, resident = 0;
  return statm >> all >> resident ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void return_freed_memory() {
#if defined(__GLIBC__)
  static_cast<void>(malloc_trim(0));
#endif
}

std::uint64_t memory_limit_bytes() { return memory_limit; }
void set_memory_limit_bytes(std::uint64_t bytes) { memory_limit = bytes; }

std::uint64_t available_memory_bytes() {
  std::ifstream in("/proc/meminfo");
  std::uint64_t available = 0;
  for (std::string key; in >> key;) {
    std::uint64_t kilobytes = 0;
    in >> kilobytes;
    if (key == "MemAvailable:") available = kilobytes * 1024;
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t limit = number_in("/sys/fs/cgroup/memory.max", none);
  const std::uint64_t used = number_in("/sys/fs/cgroup/memory.current", 0);
  // Where all is used, 1: 0 says that nothing is known.
  return limit == none ? available : std::min(available, std::max<std::uint64_t>(1, limit - std::min(limit, used)));
}

std::uint64_t free_disk_bytes(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path place = fs::absolute(path, error);
  while (!fs::exists(place, error) && place != place.parent_path()) place = place.parent_path();
  const fs::space_info space = fs::space(place, error);
  return error ? 0 : space.available;
}

std::string compiler_name() {
#if defined(__clang__)
  return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("gcc {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "unknown";
#endif
}

std::string vector_code() {
#if defined(__AVX512F__)
  const std::string units = "AVX-512";
#elif defined(__AVX2__)
  const std::string units = "AVX2";
#elif defined(__AVX__)
  const std::string units = "AVX";
#elif defined(__SSE2__)
  const std::string units = "SSE2";
#elif defined(__ARM_NEON)
  const std::string units = "NEON";
#else
  const std::string units = "of the compiler's default";
#endif
  constexpr std::string_view architecture = SHELLMATCH_BUILT_FOR;
  return architecture.empty() ? units : fmt::format("{} (-march={})", units, architecture);
}

std::string program_version() { return SHELLMATCH_VERSION; }

}  // namespace shellmatch
