#include "apps/program/program.h"

#include "apps/command_line/command_line.h"
#include "apps/process/interrupt.h"
#include "apps/process/limits.h"
#include "base/error.h"
#include "base/printable.h"
#include "base/stop.h"
#include "matching/experiment/several_errors.h"
#include "matching/progress/exit_code.h"

#include <fmt/core.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <type_traits>
#include <variant>
#include <vector>

namespace {

using namespace shellmatch;

using namespace exit_code;

int fail(int code, const std::string& text) {
  std::fputs(fmt::format("shellmatch: error: {}\n", printable(text, max_message_length)).c_str(), stderr);
  return code;
}

bool has_levels(const Invocation& invocation) {
  return std::visit(
      []<class C>(const C&) {
        return std::is_same_v<C, MatchCommand> || std::is_same_v<C, RunCommand> ||
               std::is_same_v<C, CurvatureCommand> || std::is_same_v<C, CohortCommand> ||
               std::is_same_v<C, StudyCommand>;
      },
      invocation.command);
}

// What to do where a limit was reached; the message before it says what has been kept.
int fail_at_limit(const Invocation& invocation, const KeptLimits& limits, StopCause cause, const std::string& text) {
  const char* advice = cause != StopCause::memory_limit ? ""
                       : has_levels(invocation)         ? "; give more, or match to a lower finest level (--levels)"
                                                        : "; give more";
  return fail(limit_reached, fmt::format("{}: {}{}", limits.text(cause), text, advice));
}

int perform(const Invocation& invocation) {
  const bool has_runs = std::holds_alternative<StudyCommand>(invocation.command) ||
                        std::holds_alternative<CohortCommand>(invocation.command);
  const KeptLimits limits(invocation.limits, has_runs ? KeptLimits::Memory::of_runs : KeptLimits::Memory::of_process);
  try {
    std::visit([](const auto& c) { execute(c); }, invocation.command);
    if (!std::cout.flush()) cannot_be_written(0, "the output cannot be written; is the disk full?");
    return success;
  } catch (const Stopped& stopped) {
    if (stopped.cause() != StopCause::request)
      return fail_at_limit(invocation, limits, stopped.cause(), stopped.what());
    std::fputs(fmt::format("shellmatch: {}\n", printable(stopped.what(), max_message_length)).c_str(), stderr);
    return interrupt_exit_code();
  } catch (const MemoryError& want) {
    if (invocation.limits.memory.empty()) throw;
    return fail_at_limit(invocation, limits, StopCause::memory_limit, want.what());
  } catch (const std::bad_alloc&) {
    if (!invocation.limits.memory.empty())
      return fail_at_limit(invocation, limits, StopCause::memory_limit, "not enough memory");
    return fail(memory_error, has_levels(invocation) ? "not enough memory; a lower finest level (--levels) needs less"
                                                     : "not enough memory");
  }
}

}  // namespace

int shellmatch_main(int argc, char** argv) {
  // A file that grows beyond its limit (ulimit -f) is an error of the write, which is reported and cleaned up.
  std::signal(SIGXFSZ, SIG_IGN);
  // Whoever started this program may ignore it; how the runs of a study end would then be forgotten.
  std::signal(SIGCHLD, SIG_DFL);
  try {
    return perform(parse_command_line(std::vector<std::string>(argv + 1, argv + argc)));
  } catch (const CheckFailed& error) {
    return fail(check_failed, error.what());
  } catch (const SeveralInputErrors& errors) {
    for (const std::string& text : errors.texts()) fail(input_error, text);
    return input_error;
  } catch (const InputError& error) {
    return fail(input_error, error.what());
  } catch (const MemoryError& error) {
    return fail(memory_error, error.what());
  } catch (const DiskError& error) {
    return fail(disk_error, error.what());
  } catch (const EnvironmentError& error) {
    return fail(environment_error, error.what());
  } catch (const std::system_error& error) {  // of file systems, and of threads that cannot be started
    return fail(error.code() == std::errc::no_space_on_device ? disk_error : environment_error, error.what());
  } catch (const std::exception& error) {
    return fail(internal_error, error.what());
  }
}
