// The program: parses the command line, executes the command and translates failures to exit codes.

#include "apps/command_line.h"
#include "apps/interrupt.h"
#include "base/error.h"
#include "base/printable.h"
#include "base/stop.h"

#include <fmt/core.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <variant>
#include <vector>

namespace {

enum ExitCode { success = 0, check_failed = 1, input_error = 2, environment_error = 3, internal_error = 70 };

int fail(ExitCode code, const std::string& text) {
  std::fputs(fmt::format("shellmatch: error: {}\n", shellmatch::printable(text, shellmatch::max_message_length)).c_str(), stderr);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace shellmatch;
  // A file that grows beyond its limit (ulimit -f) is an error of the write, which is reported and cleaned up.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const Command command = parse_command_line(std::vector<std::string>(argv + 1, argv + argc));
    std::visit([](const auto& c) { execute(c); }, command);
    if (!std::cout.flush()) throw_environment_error("the output cannot be written; is the disk full?");
    return success;
  } catch (const CheckFailed& error) {
    return fail(check_failed, error.what());
  } catch (const InputError& error) {
    return fail(input_error, error.what());
  } catch (const EnvironmentError& error) {
    return fail(environment_error, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(environment_error, error.what());
  } catch (const std::bad_alloc&) {
    return fail(environment_error, "not enough memory; a lower finest level (--levels) needs less");
  } catch (const Stopped& error) {
    std::fputs(fmt::format("shellmatch: {}\n", printable(error.what(), max_message_length)).c_str(), stderr);
    return interrupt_exit_code();
  } catch (const std::exception& error) {
    return fail(internal_error, error.what());
  }
}
