#pragma once
/// \file
/// A program in a process of its own, with limits of time and memory.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// 0 stands for no limit.
struct ProcessLimits {
  double seconds = 0;              ///< wall time, after which it is asked to stop (SIGTERM)
  double grace_seconds = 0;        ///< and so much later killed
  std::uint64_t memory_bytes = 0;  ///< resident memory of the process and those it has started
};

enum class ProcessEnd { exited, signalled, timed_out, out_of_memory };

struct ProcessResult {
  ProcessEnd end = ProcessEnd::exited;
  int exit_code = 0;                    ///< where it exited
  int signal = 0;                       ///< where a signal ended it
  double seconds = 0;                   ///< wall time
  std::uint64_t peak_memory_bytes = 0;  ///< resident
};

/// A running process, leader of a group of its own: what it starts is ended with it, and a signal from the
/// terminal does not reach it. The system kills it should this program die, and so does the destructor.
///
/// Memory is what is resident, polled: that is what the machine has to give, and what a user reads in `top`.
/// The address space (RLIMIT_AS) would count libraries, reserved arenas and stacks that nobody touches, which
/// is several times as much. Between two polls a process can take more; against that stands a hard limit on
/// its data segment (RLIMIT_DATA) of twice the limit and 1 GB.
class ChildProcess {
 public:
  /// \param words program (a path) and arguments; `log` receives its stdout and stderr
  /// \throws EnvironmentError if the system gives no process or the program cannot be executed
  ChildProcess(const std::vector<std::string>& words, const std::string& log, const ProcessLimits& limits);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Looks after the limits; the result once the process has ended. To be called every few hundredths of a
  /// second.
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
