#include "apps/command_line/command_line.h"

#include "apps/command_line/describe_commands.h"
#include "apps/command_line/help_text.h"
#include "apps/command_line/shared_options.h"
#include "apps/command_line/slicer_module.h"
#include "apps/studies/execution/machine.h"
#include "base/error.h"
#include "base/options.h"
#include "matching/progress/linked_libraries.h"
#include "matching/progress/process_info.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

// CLI11's complaint names the words that it could not use; the suggestion is made from the words themselves.
// \throws InputError always
[[noreturn]] void explain_parse_error(const CLI::App& app, const std::vector<std::string>& words,
                                      const std::string& complaint) {
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

// The program with its revision, the compiler, the vector units of the code that runs, and each linked library with
// its version, its licence and what that asks of a distributed program.
std::string versions_text() {
  const std::string revision = build_revision();
  std::string text =
      fmt::format("shellmatch {}{}, made by {}\nlicence: GPL-3.0-or-later\nvector code: {}\n\n", program_version(),
                  revision.empty() ? "" : fmt::format(" ({})", revision), compiler_name(), vector_code());
  constexpr const char* row = "{:<14} {:<10} {:<20} {}\n";
  text += fmt::format(row, "library", "version", "binds", "licence");
  for (const LinkedLibrary& library : linked_libraries())
    text += fmt::format(row, library.name, library.version, library.binds, library.licence);
  return text + "\n'binds' is what a library asks of a distributed program; docs/licences.md says what follows.\n";
}

// The data of all commands. CLI11 fills those of the command that is named.
struct Commands {
  MatchCommand match;
  RunCommand run;
  GenerateCommand generate;
  ApplyCommand apply;
  InspectCommand inspect;
  CurvatureCommand curvature;
  CheckGradientCommand check_gradient;
  SelfTestCommand self_test;
  ViewCommand view;
  RenderCommand render;
  ConfigCommand config;
  StudyCommand study;
  CohortCommand cohort;
  Limits limits;  ///< of whichever it is
};

// What CLI11 2.6 does otherwise: it no longer says that the first line of a command's help is its usage, and breaks the
// lines of descriptions and of examples anew.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { keep_lines(*this); }
  std::string make_usage(const CLI::App* app, std::string name) const override {
    const std::string usage = CLI::Formatter::make_usage(app, std::move(name)), label = get_label("Usage");
    const std::size_t begin = usage.find_first_not_of('\n');
    if (begin == std::string::npos || usage.find(label) == begin) return usage;
    return label + ": " + usage.substr(begin);
  }

 private:
  template <class Formatter>
  static void keep_lines(Formatter& formatter) {
    if constexpr (requires { formatter.enable_footer_formatting(false); }) {
      formatter.enable_description_formatting(false);
      formatter.enable_footer_formatting(false);
    }
  }
};

void describe_all(CLI::App& app, Commands& commands) {
  app.footer(help_text::program_footer);
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->column_width(34);
  CLI::Option* version = app.set_version_flag("--version", "shellmatch " SHELLMATCH_VERSION, "print the version");
  app.add_flag_function(
         "-v,--verbose", [](std::int64_t) {}, "with --version: versions and licences of all that is linked, too")
      ->needs(version);
  app.require_subcommand(1);
  // In the order of the help.
  describe(app, commands.match);
  describe(app, commands.run);
  describe(app, commands.study);
  describe(app, commands.cohort);
  describe(app, commands.generate);
  describe(app, commands.apply);
  describe(app, commands.inspect);
  describe(app, commands.curvature);
  describe(app, commands.check_gradient);
  describe(app, commands.self_test);
  describe(app, commands.view);
  describe(app, commands.render);
  describe(app, commands.config);
  for (CLI::App* command : app.get_subcommands({})) add_limits(*command, commands.limits);
  for (const char* name : {"match", "apply"})
    app.get_subcommand(name)->add_flag_callback(
        "--xml",
        [] { throw_input_error("--xml: stands alone behind the command, with which it prints the description"); },
        "alone: describe this command as a module of 3D Slicer (docs/slicer.md)");
}

// The command of this name, with what it needs.
Command named_command(const std::string& name, const Commands& commands) {
  const auto require_output = [&](const std::string& output, const char* what) {
    if (output.empty()) throw_input_error("{}: say where to write: -o {} (see shellmatch {} --help)", name, what, name);
  };
  if (name == "match") {
    require_output(commands.match.settings.output, "DIR");
    return commands.match;
  }
  if (name == "run") return commands.run;
  if (name == "study") return commands.study;
  if (name == "cohort") return commands.cohort;
  if (name == "generate") {
    if (commands.generate.shape.empty() && !commands.generate.list)
      throw_input_error("generate: say which shape; `shellmatch generate --list` lists them");
    if (!commands.generate.list) require_output(commands.generate.output, "FILE");
    return commands.generate;
  }
  if (name == "apply") {
    const ApplyCommand& apply = commands.apply;
    const bool has_fields = !apply.displacement.empty() || !apply.jacobian.empty() || !apply.log_jacobian.empty();
    if (apply.file.empty() && !has_fields)
      throw_input_error("apply: say what to move: apply DIR FILE -o OUTPUT (see shellmatch apply --help)");
    if (!apply.file.empty()) require_output(apply.output, "FILE");
    else if (!apply.output.empty())
      throw_input_error("apply: -o {}: there is no FILE to move (see shellmatch apply --help)", apply.output);
    return commands.apply;
  }
  if (name == "inspect") return commands.inspect;
  if (name == "curvature") {
    require_output(commands.curvature.settings.output, "DIR");
    return commands.curvature;
  }
  if (name == "check-gradient") return commands.check_gradient;
  if (name == "self-test") return commands.self_test;
  if (name == "view") return commands.view;
  if (name == "render") {
    require_output(commands.render.output, commands.render.motion.empty() ? "FILE" : "FILE.webp, or a folder");
    return commands.render;
  }
  return commands.config;
}

// 3D Slicer names flags like variables: --max_seconds is --max-seconds.
std::vector<std::string> with_hyphens(std::vector<std::string> words) {
  for (std::string& word : words)
    if (word.starts_with("--")) std::replace(word.begin(), std::find(word.begin(), word.end(), '='), '_', '-');
  return words;
}

// What Slicer asks modules for, before it runs them.
bool asks_for_module(const std::vector<std::string>& words) {
  return std::ranges::find(words, "--xml") != words.end() && words.size() <= 2 &&
         (words.size() == 1 || words[1] == "--xml");
}

std::string module_text(const CLI::App& app, const std::string& name) {
  if (name != "match" && name != "apply")
    throw_input_error(
        "--xml: a command line module of 3D Slicer is one command; ask shellmatch match --xml or shellmatch apply "
        "--xml (docs/slicer.md)");
  return slicer_module_xml(*app.get_subcommand(name));
}

}  // namespace

Invocation parse_command_line(const std::vector<std::string>& given) {
  const std::vector<std::string> words = with_hyphens(given);
  Commands commands;
  CLI::App app{help_text::program, "shellmatch"};
  describe_all(app, commands);
  if (asks_for_module(words)) return {PrintCommand{module_text(app, words.front())}, {}};
  try {
    // CLI11 expects the words in reverse order.
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    return {PrintCommand{app.help()}, {}};
  } catch (const CLI::CallForVersion&) {
    const bool is_verbose =
        std::ranges::any_of(words, [](const std::string& w) { return w == "-v" || w == "--verbose"; });
    return {PrintCommand{is_verbose ? versions_text() : "shellmatch " SHELLMATCH_VERSION "\n"}, {}};
  } catch (const CLI::ParseError& error) {
    std::string complaint = error.what();
    std::replace(complaint.begin(), complaint.end(), '\n', ' ');
    explain_parse_error(app, words, complaint);
  }
  return {named_command(app.get_subcommands().front()->get_name(), commands), commands.limits};
}

}  // namespace shellmatch
