#pragma once
/// \file
/// The adapter of CLI11: from the words of the command line to a command.

#include "apps/commands.h"

#include <string>
#include <vector>

namespace shellmatch {

/// \param words those after the program's name
/// \throws InputError in one line, with the nearest valid spelling of a misspelt command or option
Command parse_command_line(const std::vector<std::string>& words);

}  // namespace shellmatch
