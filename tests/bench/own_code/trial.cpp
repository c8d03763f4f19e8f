#include "tests/bench/own_code/trial.h"

#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <string>

namespace shellmatch::own_code {

namespace {

// A line of /proc/self/status such as "VmHWM:   1234 kB", in MB.
double status_megabytes(const std::string& key) {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size())) / 1e3;
  return 0;
}

}  // namespace

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Trial run_trial(const std::function<void(Trial&)>& work, unsigned limit_seconds) {
  std::fflush(nullptr);  // or what is waiting would be written by the child, too, if a library calls exit()
  malloc_trim(0);        // so that memory which is taken again counts
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    alarm(limit_seconds);
    // Whatever a library prints about a damaged file.
    const int nothing = open("/dev/null", O_WRONLY);
    dup2(nothing, STDERR_FILENO);
    Trial trial;
    const double before = status_megabytes("VmRSS:");
    work(trial);
    trial.returned = true;
    trial.megabytes = status_megabytes("VmHWM:") - before;
    const bool written = write(ends[1], &trial, sizeof trial) == static_cast<ssize_t>(sizeof trial);
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  Trial trial;
  const bool whole = read(ends[0], &trial, sizeof trial) == static_cast<ssize_t>(sizeof trial);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return whole ? trial : Trial{};
}

}  // namespace shellmatch::own_code
