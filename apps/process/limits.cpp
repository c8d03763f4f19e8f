#include "apps/process/limits.h"

#include "apps/process/interrupt.h"
#include "base/error.h"
#include "matching/progress/process_info.h"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace shellmatch {

namespace {

using Clock = std::chrono::steady_clock;

// A positive number at the beginning of a text, and what follows it; 0 where there is none.
std::pair<double, std::string> number_and_rest(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value) || !(value > 0)) return {0, text};
  return {value, std::string(end, text.data() + text.size())};
}

// Looks at the resident memory of this process every hundredth of a second, on a thread of its own.
class MemoryWatch {
 public:
  explicit MemoryWatch(std::uint64_t bytes)
      : thread_([this, bytes](const std::stop_token& ended) {
          std::unique_lock lock(mutex_);
          while (!wake_.wait_for(lock, ended, std::chrono::milliseconds(10), [&] { return ended.stop_requested(); }))
            if (resident_memory_bytes() > bytes) is_exceeded_ = true;
        }) {}
  bool is_exceeded() const { return is_exceeded_; }

 private:
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::atomic<bool> is_exceeded_ = false;
  std::jthread thread_;  // the last member, which ends first
};

// Set before any thread asks.
std::optional<Clock::time_point> deadline;
std::optional<MemoryWatch> watch;

}  // namespace

std::uint64_t parse_memory(const std::string& text) {
  if (text.empty()) return 0;
  const auto [value, unit] = number_and_rest(text);
  const double factor = unit == "MB" ? 1e6 : unit == "GB" ? 1e9 : 0;
  const double bytes = value * factor;
  if (!(bytes >= 1e6 && bytes <= 1e18))
    throw_input_error("--max-memory {}: expected a number with its unit, at least 1MB, as 800MB or 4GB", text);
  return static_cast<std::uint64_t>(bytes);
}

double parse_seconds(const std::string& text) {
  if (text.empty()) return 0;
  const auto [value, rest] = number_and_rest(text);
  if (!(value > 0) || !rest.empty() || value > 1e9)
    throw_input_error("--max-seconds {}: expected a number of seconds above 0, as 600", text);
  return value;
}

StopCause stop_cause() {
  if (interrupt_requested()) return StopCause::request;
  if (deadline && Clock::now() >= *deadline) return StopCause::time_limit;
  if (watch && watch->is_exceeded()) return StopCause::memory_limit;
  return StopCause::none;
}

KeptLimits::KeptLimits(const Limits& limits, Memory memory) : limits_(limits) {
  const double seconds = parse_seconds(limits.seconds);
  const std::uint64_t bytes = parse_memory(limits.memory);
  if (seconds > 0)
    deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  set_memory_limit_bytes(bytes);
  if (bytes > 0 && memory == Memory::of_process) {
    watch.emplace(bytes);
    // Between two looks, and in libraries that run no loop of ours, allocations beyond the limit fail. The data segment
    // counts pages that nothing has touched as well: stacks of threads, and room that the allocator keeps.
    rlimit limit{};
    if (getrlimit(RLIMIT_DATA, &limit) == 0) {
      limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, bytes + bytes / 2 + (rlim_t{1} << 28));
      setrlimit(RLIMIT_DATA, &limit);
    }
  }
  stop_loops_when(stop_cause);
}

KeptLimits::~KeptLimits() {
  stop_loops_when(nullptr);
  watch.reset();
  deadline.reset();
  set_memory_limit_bytes(0);
}

std::string KeptLimits::text(StopCause cause) const {
  if (cause == StopCause::time_limit) return fmt::format("--max-seconds {} is over", limits_.seconds);
  return fmt::format("--max-memory {} does not suffice", limits_.memory);
}

}  // namespace shellmatch
