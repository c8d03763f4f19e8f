#include "apps/studies/execution/child_process.h"

#include "base/error.h"
#include "matching/progress/process_info.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <utility>

namespace shellmatch {

namespace {

// Resident memory in bytes of a process and its descendants; 0 if it has ended.
std::uint64_t resident_bytes(int pid, int depth = 0) {
  std::uint64_t bytes = resident_memory_bytes(std::to_string(pid));
  if (bytes > 0 && depth < 8) {
    std::ifstream children(fmt::format("/proc/{}/task/{}/children", pid, pid));
    for (int child = 0; children >> child;) bytes += resident_bytes(child, depth + 1);
  }
  return bytes;
}

// Runs between fork and exec, where only async-signal-safe functions may be called. Writes errno to `report` on
// failure.
[[noreturn]] void become(char* const* arguments, int log, int report, int parent, const ProcessLimits& limits) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // the parent died before prctl took effect
  for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_DFL);
  if (limits.memory_bytes > 0) {
    const rlim_t most = 2 * limits.memory_bytes + (rlim_t{1} << 30);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_DATA, &limit);
  }
  // A crash is a result of the study: no core file is needed.
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execv(arguments[0], arguments);
  const int error = errno;
  if (write(report, &error, sizeof error) < 0) _exit(126);
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words, const std::string& log, const ProcessLimits& limits)
    : limits_(limits) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  int report[2] = {-1, -1};
  const auto fail = [&](const char* what) {
    const int error = errno;
    for (const int fd : {file, report[0], report[1]})
      if (fd >= 0) close(fd);
    throw_environment_error("{}: {}: {}", words.front(), what, std::strerror(error));
  };
  if (file < 0) fail("its log cannot be written");
  if (pipe2(report, O_CLOEXEC) != 0) fail("no pipe to it can be made");
  const int self = getpid();
  pid_ = fork();
  if (pid_ < 0) fail("the system starts no further process");
  if (pid_ == 0) become(arguments.data(), file, report[1], self, limits);
  setpgid(pid_, pid_);  // both parent and child set the group, as their order is undefined
  close(file);
  close(report[1]);
  // The exec closes the pipe; if it fails, the pipe delivers its error.
  int error = 0;
  ssize_t n = 0;
  while ((n = read(report[0], &error, sizeof error)) < 0 && errno == EINTR) {
  }
  close(report[0]);
  if (n == static_cast<ssize_t>(sizeof error)) {
    waitpid(std::exchange(pid_, -1), nullptr, 0);
    throw_environment_error("{}: cannot be executed: {}", words.front(), std::strerror(error));
  }
}

ChildProcess::~ChildProcess() {
  if (pid_ < 0) return;
  kill(-pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

double ChildProcess::seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

void ChildProcess::look_after_limits() {
  const std::uint64_t resident = resident_bytes(pid_);
  peak_ = std::max(peak_, resident);
  if (limits_.memory_bytes > 0 && resident > limits_.memory_bytes) {
    out_of_memory_ = true;
    kill(-pid_, SIGKILL);
  }
  if (limits_.seconds <= 0) return;
  const double t = seconds();
  if (t > limits_.seconds + limits_.grace_seconds) {
    asked_ = true;
    kill(-pid_, SIGKILL);
  } else if (t > limits_.seconds && !asked_) {
    asked_ = true;
    kill(-pid_, SIGTERM);
  }
}

std::optional<ProcessResult> ChildProcess::poll() {
  SHELLMATCH_CHECK(pid_ > 0, "a process that has ended is not asked again");
  int status = 0;
  rusage usage{};
  const int ended = wait4(pid_, &status, WNOHANG, &usage);
  if (ended == 0) {
    look_after_limits();
    return std::nullopt;
  }
  ProcessResult result;
  result.seconds = seconds();
  kill(-pid_, SIGKILL);  // kills processes that the child has left
  pid_ = -1;
  result.peak_memory_bytes = std::max(peak_, static_cast<std::uint64_t>(usage.ru_maxrss) * 1024);
  if (ended > 0 && WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (ended > 0 && WIFSIGNALED(status)) {
    result.end = ProcessEnd::signalled;
    result.signal = WTERMSIG(status);
  }
  if (asked_) result.end = ProcessEnd::timed_out;
  if (out_of_memory_) result.end = ProcessEnd::out_of_memory;
  return result;
}

}  // namespace shellmatch
