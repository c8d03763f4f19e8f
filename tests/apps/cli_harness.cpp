#include "tests/apps/cli_harness.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace shellmatch {

namespace {

using Clock = std::chrono::steady_clock;

void check(bool ok, const char* what) {
  if (!ok) throw std::runtime_error(std::string("test harness: ") + what + " failed");
}

// Appends what is there; closes at the end of the stream.
void read_some(int& fd, std::string& text) {
  char buffer[4096];
  const ssize_t n = read(fd, buffer, sizeof buffer);
  if (n > 0) {
    text.append(buffer, static_cast<std::size_t>(n));
  } else if (n == 0 || errno != EINTR) {
    close(fd);
    fd = -1;
  }
}

}  // namespace

Program::Program(const std::vector<std::string>& words, const std::string& folder) {
  int out[2], err[2];
  check(pipe2(out, O_CLOEXEC) == 0 && pipe2(err, O_CLOEXEC) == 0, "pipe");
  std::vector<char*> arguments{const_cast<char*>(SHELLMATCH_PROGRAM)};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_ = fork();
  check(pid_ >= 0, "fork");
  if (pid_ == 0) {
    dup2(out[1], STDOUT_FILENO);
    dup2(err[1], STDERR_FILENO);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    if (folder.empty() || chdir(folder.c_str()) == 0) execv(SHELLMATCH_PROGRAM, arguments.data());
    _exit(127);
  }
  close(out[1]);
  close(err[1]);
  out_fd_ = out[0];
  err_fd_ = err[0];
}

Program::~Program() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  for (const int fd : {out_fd_, err_fd_})
    if (fd >= 0) close(fd);
}

void Program::send_signal(int signal) const { check(kill(pid_, signal) == 0, "kill"); }

bool Program::wait_for_handler(int signal, std::chrono::milliseconds limit) const {
  const std::string key = "SigCgt:";  // a mask in hexadecimal digits, proc(5)
  for (const Clock::time_point deadline = Clock::now() + limit; Clock::now() < deadline;
       std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
    std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.starts_with(key) && (std::stoull(line.substr(key.size()), nullptr, 16) >> (signal - 1) & 1) != 0)
        return true;
  }
  return false;
}

// One round of reading; false when both streams have ended or the time is over.
bool Program::collect(Clock::time_point deadline) {
  if (out_fd_ < 0 && err_fd_ < 0) return false;
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
  if (left <= 0) return false;
  // poll() passes over negative descriptors.
  pollfd fds[] = {{out_fd_, POLLIN, 0}, {err_fd_, POLLIN, 0}};
  if (poll(fds, 2, static_cast<int>(std::min<long>(left, 60000))) <= 0)
    return errno == EINTR || Clock::now() < deadline;
  if (fds[0].revents != 0) read_some(out_fd_, result_.out);
  if (fds[1].revents != 0) read_some(err_fd_, result_.err);
  return true;
}

ProgramResult Program::wait(std::chrono::milliseconds limit) {
  const Clock::time_point deadline = Clock::now() + limit;
  while (collect(deadline)) {
  }
  int status = 0;
  while (waitpid(pid_, &status, WNOHANG) == 0) {
    if (Clock::now() >= deadline) {
      kill(pid_, SIGKILL);
      result_.timed_out = true;
      waitpid(pid_, &status, 0);
      break;
    }
    usleep(1000);
  }
  pid_ = -1;
  result_.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result_;
}

bool Program::wait_for_stderr(const std::string& text, std::chrono::milliseconds limit) {
  const Clock::time_point deadline = Clock::now() + limit;
  while (result_.err.find(text) == std::string::npos)
    if (!collect(deadline)) return false;
  return true;
}

std::string last_line(const std::string& text) {
  const std::size_t begin = text.rfind('\n', text.size() - 2);
  return text.substr(begin == std::string::npos ? 0 : begin + 1);
}

ProgramResult run_program(const std::vector<std::string>& words, const std::string& folder,
                          std::chrono::milliseconds limit) {
  return Program(words, folder).wait(limit);
}

ProgramResult run_in_child(const Words& words, const std::function<bool()>& prepare) {
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    if (!prepare()) _exit(99);
    const ProgramResult result = run_program(words);
    if (write(pipe_ends[1], result.err.data(), std::min<std::size_t>(result.err.size(), 60000)) < 0) _exit(98);
    _exit(result.exit_code);
  }
  close(pipe_ends[1]);
  ProgramResult result;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(pipe_ends[0], buffer, sizeof buffer)) > 0;)
    result.err.append(buffer, static_cast<std::size_t>(n));
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

bool obey_permissions() {
  return geteuid() != 0 ||
         (prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE) == 0 && prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH) == 0);
}

}  // namespace shellmatch
