// `match` and `run`: an experiment from the command line and, for the latter, a YAML file.

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/progress.h"
#include "base/error.h"
#include "matching/run_matching.h"
#include "matching/yaml_options.h"

#include <filesystem>

namespace shellmatch {

namespace {

// Named options first, so that --set wins over them.
std::vector<Override> overrides_of(const RunSettings& settings) {
  std::vector<Override> overrides;
  const auto add = [&](const char* key, const std::string& value, const char* option) {
    if (!value.empty()) overrides.push_back({key, value, fmt::format("{} {}", option, value)});
  };
  add("profile", settings.profile, "--profile");
  if (!settings.levels.empty()) {
    const std::size_t colon = settings.levels.find(':');
    if (colon == std::string::npos)
      throw_input_error("--levels {}: expected the coarsest and the finest level as MIN:MAX, for example 3:7",
                        settings.levels);
    const std::string origin = "--levels " + settings.levels;
    overrides.push_back({"cascade.min_level", settings.levels.substr(0, colon), origin});
    overrides.push_back({"cascade.max_level", settings.levels.substr(colon + 1), origin});
  }
  add("input.placement", settings.placement, "--placement");
  add("threads", settings.threads, "--threads");
  for (const std::string& assignment : settings.assignments) overrides.push_back(parse_override(assignment));
  return overrides;
}

void match(const ExperimentOptions& options, const std::string& output, const RunSettings& settings) {
  catch_interrupts();
  Progress progress(settings.verbosity, options.cascade.max_level);
  run_matching(options, output, settings.force, progress);
  if (interrupt_requested()) throw Interrupted(fmt::format("stopped on request; what was reached is in {}", output));
  progress.note(fmt::format("written: {}", output));
}

}  // namespace

void execute(const MatchCommand& command) {
  std::vector<Override> overrides = {{"input.reference", command.reference, "REFERENCE"},
                                     {"input.template", command.template_shape, "TEMPLATE"}};
  for (Override& change : overrides_of(command.settings)) overrides.push_back(std::move(change));
  match(make_experiment(overrides), command.settings.output, command.settings);
}

void execute(const RunCommand& command) {
  const ExperimentOptions options = read_experiment(command.config, overrides_of(command.settings));
  for (const auto& [key, source] : {std::pair{"reference", &options.input.reference},
                                    std::pair{"template", &options.input.template_file}})
    if (source->empty())
      throw_input_error("{}: input.{}: is missing; expected the file of the shape, or a built-in one as generate:hand",
                        command.config, key);
  const std::string name = std::filesystem::path(command.config).stem().string();
  match(options, command.settings.output.empty() ? "out/" + name : command.settings.output, command.settings);
}

}  // namespace shellmatch
