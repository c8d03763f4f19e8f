#include "apps/studies/execution/machine.h"

#include "base/error.h"
#include "matching/progress/linked_libraries.h"
#include "matching/progress/process_info.h"

#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace shellmatch {

int n_processors() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
  return static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
}

std::string machine_text() {
  std::string processor = "unknown processor";
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) {
      processor = line.substr(line.find(':') + 2);
      break;
    }
  const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return fmt::format("{}, {} cores, {:.0f} GB", processor, n_processors(), bytes / (1 << 30));
}

double machine_load() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

std::vector<std::pair<std::string, std::string>> versions() {
  const std::string revision = build_revision();
  std::vector<std::pair<std::string, std::string>> list = {
      {"shellmatch", program_version() + (revision.empty() ? "" : " (" + revision + ")")},
      {"compiler", compiler_name()}};
  for (const LinkedLibrary& library : linked_libraries()) list.emplace_back(library.name, library.version);
  utsname system{};
  if (uname(&system) == 0) list.emplace_back(system.sysname, system.release);
  return list;
}

}  // namespace shellmatch
