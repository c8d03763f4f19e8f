#include "apps/command_line/parse_error.h"

#include "base/error.h"
#include "base/options.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace shellmatch {

namespace {

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

// The names of all options of the command, such as "--levels" and "-o".
std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

}  // namespace

void explain_parse_error(const CLI::App& app, const std::vector<std::string>& words, const std::string& complaint) {
  const std::vector<std::string> commands = names_of_commands(app);
  const auto named = std::find_if(words.begin(), words.end(), [](const std::string& w) { return w[0] != '-'; });
  const bool known = named != words.end() && std::find(commands.begin(), commands.end(), *named) != commands.end();
  const CLI::App& command = known ? *app.get_subcommand(*named) : app;
  const std::string help = known ? fmt::format("shellmatch {} --help", *named) : "shellmatch --help";
  if (named == words.end() && words.empty())
    throw_input_error("a command is missing; expected one of {} (see {})", fmt::join(commands, ", "), help);

  const std::vector<std::string> options = names_of_options(command);
  for (auto word = known ? named + 1 : words.begin(); word != (known ? words.end() : named); ++word) {
    const std::string name = word->substr(0, word->find('='));
    if (name.size() < 2 || name[0] != '-' || (name[1] != '-' && std::isdigit(static_cast<unsigned char>(name[1]))))
      continue;
    if (std::find(options.begin(), options.end(), name) != options.end()) continue;
    if (name[1] != '-' && std::find(options.begin(), options.end(), name.substr(0, 2)) != options.end()) continue;
    const std::string near = nearest_word(name, options);
    throw_input_error("unknown option {}{} (see {})", name, near.empty() ? "" : fmt::format("; did you mean {}?", near),
                      help);
  }
  if (!known && named != words.end()) {
    const std::string near = nearest_word(*named, commands);
    throw_input_error("unknown command {}; {}expected one of {} (see {})", *named,
                      near.empty() ? "" : fmt::format("did you mean {}? ", near), fmt::join(commands, ", "), help);
  }
  throw_input_error("{} (see {})", complaint, help);
}

}  // namespace shellmatch
