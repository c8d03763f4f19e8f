#pragma once
/// \file
/// What commands have in common on the command line.

#include "apps/commands.h"
#include "apps/process/limits.h"

#include <string>

namespace CLI {
class App;
}

namespace shellmatch {

/// \param footer what `--help` prints below the options
CLI::App* add_command(CLI::App& app, const char* name, const char* meaning, const std::string& footer);

/// -q and -v. \param more what -v adds
void add_verbosity(CLI::App& command, Verbosity& verbosity, const char* more);

/// The options that all commands reading an experiment share.
void add_experiment_settings(CLI::App& command, RunSettings& settings, const char* force_meaning,
                             const char* verbose_meaning);

/// Those, and an output folder and levels.
void add_output_settings(CLI::App& command, RunSettings& settings, const std::string& output_meaning);

/// The limits that every command has.
void add_limits(CLI::App& command, Limits& limits);

}  // namespace shellmatch
