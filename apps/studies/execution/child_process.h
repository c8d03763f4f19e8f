#pragma once
/// \file
/// Runs a program in a separate process, with limits of time and memory.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// Limits of a process; 0 means no limit.
struct ProcessLimits {
  double seconds = 0;              ///< wall time after which SIGTERM is sent
  double grace_seconds = 0;        ///< additional time after which SIGKILL is sent
  std::uint64_t memory_bytes = 0;  ///< resident memory of the process and its descendants
};

enum class ProcessEnd { exited, signalled, timed_out, out_of_memory };

struct ProcessResult {
  ProcessEnd end = ProcessEnd::exited;
  int exit_code = 0;                    ///< valid if it exited
  int signal = 0;                       ///< valid if a signal ended it
  double seconds = 0;                   ///< wall time
  std::uint64_t peak_memory_bytes = 0;  ///< resident
};

/// A running process, leader of its own process group: its descendants are ended with it, and signals from the terminal
/// do not reach it. The destructor kills it, and so does the system if this program dies.
///
/// The limit of memory applies to resident memory, which is polled: it is the memory that the machine provides, and
/// what `top` shows. The address space (RLIMIT_AS) also counts libraries, reserved arenas and untouched stacks, several
/// times as much. Between two polls a process may exceed the limit; therefore its data segment (RLIMIT_DATA) has a hard
/// limit of twice the limit plus 1 GB.
class ChildProcess {
 public:
  /// \param words program (a path) and arguments; `log` receives stdout and stderr
  /// \throws EnvironmentError if no process can be created or the program cannot be executed
  ChildProcess(const std::vector<std::string>& words, const std::string& log, const ProcessLimits& limits);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Enforces the limits; returns the result once the process has ended. Call it every few hundredths of a second.
  std::optional<ProcessResult> poll();

 private:
  double seconds() const;
  void look_after_limits();

  using Clock = std::chrono::steady_clock;
  int pid_ = -1;
  ProcessLimits limits_;
  Clock::time_point begin_ = Clock::now();
  std::uint64_t peak_ = 0;
  bool asked_ = false, out_of_memory_ = false;
};

}  // namespace shellmatch
