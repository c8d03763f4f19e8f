// `view`: opens the page of a result in the browser.

#include "apps/commands.h"
#include "base/error.h"
#include "matching/report/report.h"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace shellmatch {

namespace {

namespace fs = std::filesystem;

fs::path report_in(const std::string& given) {
  std::error_code error;
  const fs::path path = fs::absolute(given);
  if (!fs::exists(path, error)) throw_input_error("{}: is not there; give the output folder of a run", given);
  if (!fs::is_directory(path, error)) {
    if (path.extension() != ".html")
      throw_input_error("{}: is no report; give the output folder of a run, or its {}", given, report_file_name);
    return path;
  }
  const fs::path report = path / report_file_name;
  if (fs::is_regular_file(report, error)) return report;
  if (!fs::exists(path / "config.yaml", error))
    throw_input_error("{}: is not the output folder of a run: it has no {}", given, report_file_name);
  throw_input_error("{}: has no {}; make the result again with one: shellmatch run {} -o NEW_FOLDER --set report=true",
                    given, report_file_name, (fs::path(given) / "config.yaml").string());
}

// Whether a program was started that opens the file. It may go on after this one, and says nothing here.
bool open_in_browser(const std::string& file) {
  const auto is_set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) return false;
  posix_spawn_file_actions_t silence;
  posix_spawn_file_actions_init(&silence);
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&silence, fd, "/dev/null", O_RDWR, 0);
  std::string name = "xdg-open", argument = file;
  char* const words[] = {name.data(), argument.data(), nullptr};
  pid_t pid = 0;
  const bool started = ::posix_spawnp(&pid, name.c_str(), &silence, nullptr, words, environ) == 0;
  posix_spawn_file_actions_destroy(&silence);
  return started;
}

}  // namespace

void execute(const ViewCommand& command) {
  const std::string report = report_in(command.folder).string();
  std::cout << report << "\n";
  if (!command.print_only && !open_in_browser(report))
    std::cerr << "no display or no xdg-open here: open this file in a browser\n";
}

}  // namespace shellmatch
