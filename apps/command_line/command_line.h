#pragma once
/// \file
/// The adapter of CLI11: parses the words of the command line into a command.

#include "apps/commands.h"
#include "apps/process/limits.h"

#include <string>
#include <vector>

namespace shellmatch {

/// A command, and what it may cost.
struct Invocation {
  Command command;
  Limits limits;
};

/// \param words the arguments without the program's name
/// \throws InputError of one line, with the nearest valid spelling of a misspelt command or option
Invocation parse_command_line(const std::vector<std::string>& words);

}  // namespace shellmatch
