#include "apps/command_line/shared_options.h"

#include "base/error.h"
#include "matching/experiment/option_tree.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <stdexcept>

namespace shellmatch {

namespace {

void set_verbosity(Verbosity& present, Verbosity verbosity) {
  if (present != Verbosity::normal && present != verbosity)
    throw_input_error("--quiet and --verbose exclude each other");
  present = verbosity;
}

/// Of an option at the top of an experiment's YAML file.
std::string meaning_of(const std::string& option) {
  ExperimentOptions options;
  const OptionNode all = option_tree(options);
  const auto it = std::ranges::find(all.children, option, &OptionNode::name);
  if (it == all.children.end()) throw std::logic_error("there is no option " + option);
  return std::string(it->info.meaning);
}

}  // namespace

CLI::App* add_command(CLI::App& app, const char* name, const char* meaning, const std::string& footer) {
  CLI::App* command = app.add_subcommand(name, meaning);
  command->footer(footer);
  return command;
}

void add_verbosity(CLI::App& command, Verbosity& verbosity, const char* more) {
  command.add_flag_function(
      "-q,--quiet", [&](std::int64_t) { set_verbosity(verbosity, Verbosity::quiet); }, "errors only");
  command.add_flag_function(
      "-v,--verbose", [&](std::int64_t) { set_verbosity(verbosity, Verbosity::verbose); }, more);
}

void add_experiment_settings(CLI::App& command, RunSettings& settings, const char* force_meaning,
                             const char* verbose_meaning) {
  command
      .add_option("--placement", settings.placement,
                  "fit moves both shapes into the unit domain together, as-is leaves them where they are")
      ->type_name("fit|as-is");
  command
      .add_option("--align", settings.align,
                  "auto finds the pose and pairs of points before the matching (docs/alignment.md)")
      ->type_name("none|auto|rigid|similarity|landmarks");
  command
      .add_option("--landmarks", settings.landmarks,
                  "points that correspond: CSV, .fcsv, .mrk.json or .tps (docs/landmarks.md)")
      ->type_name("FILE");
  command
      .add_option("--template-landmarks", settings.template_landmarks,
                  "file of the template's points, where --landmarks has those of the reference alone")
      ->type_name("FILE");
  command.add_flag("--strict", settings.strict,
                   "refuse meshes that are not closed, instead of closing them (docs/closing.md)");
  command.add_option("--profile", settings.profile, meaning_of("profile"))->type_name("default|paper");
  command.add_option("--threads", settings.threads, meaning_of("threads"))->type_name("N");
  command.add_option("--set", settings.assignments, "any other option (`shellmatch config` lists them); repeatable")
      ->type_name("KEY.SUB=VALUE")
      ->allow_extra_args(false);
  command.add_flag("--force", settings.force, force_meaning);
  add_verbosity(command, settings.verbosity, verbose_meaning);
}

void add_output_settings(CLI::App& command, RunSettings& settings, const std::string& output_meaning) {
  command.add_option("-o,--output", settings.output, output_meaning)->type_name("DIR");
  command.add_option("--levels", settings.levels, "coarsest and finest level; cells have side 2^-level")
      ->type_name("MIN:MAX");
  add_experiment_settings(command, settings, "replace the output folder of an earlier run", "every iteration");
}

void add_limits(CLI::App& command, Limits& limits) {
  command.add_option("--max-seconds", limits.seconds, "stop in order after this time (exit code 4)")
      ->type_name("SECONDS");
  command
      .add_option("--max-memory", limits.memory,
                  "stop in order before more is used (exit code 4); runs of a study or cohort together")
      ->type_name("800MB|4GB");
}

}  // namespace shellmatch
