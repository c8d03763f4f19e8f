#include "apps/experiment_overrides.h"

#include "base/error.h"
#include "matching/experiment/yaml_options.h"

#include <utility>

namespace shellmatch {

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
  add("align.mode", settings.align, "--align");
  add("landmarks.file", settings.landmarks, "--landmarks");
  add("landmarks.template_file", settings.template_landmarks, "--template-landmarks");
  add("input.placement", settings.placement, "--placement");
  if (settings.strict) overrides.push_back({"input.close", "never", "--strict"});
  add("threads", settings.threads, "--threads");
  for (const std::string& assignment : settings.assignments) overrides.push_back(parse_override(assignment));
  return overrides;
}

namespace {

// A profile stands for defaults, and a file that sets all options leaves nothing to them: the profile would only be
// recorded.
void check_profile_acts(const std::string& config, const RunSettings& settings, const ExperimentOptions& options,
                        std::vector<Override> overrides) {
  if (settings.profile.empty()) return;
  std::erase_if(overrides, [](const Override& change) { return change.key == "profile"; });
  ExperimentOptions without = read_experiment(config, std::move(overrides));
  if (without.profile == options.profile) return;
  without.profile = options.profile;
  if (to_yaml(without) == to_yaml(options))
    throw_input_error(
        "--profile {}: {} sets every option in which the profiles differ, so that nothing would change; leave it out, "
        "or give "
        "options with --set",
        settings.profile, config);
}

}  // namespace

ExperimentOptions read_run_options(const std::string& config, const RunSettings& settings) {
  const std::vector<Override> overrides = overrides_of(settings);
  const ExperimentOptions options = read_experiment(config, overrides);
  check_profile_acts(config, settings, options, overrides);
  for (const auto& [key, source] :
       {std::pair{"reference", &options.input.reference}, std::pair{"template", &options.input.template_file}})
    if (source->empty())
      throw_input_error("{}: input.{}: is missing; expected the file of the shape, or a built-in one as generate:hand",
                        config, key);
  return options;
}

}  // namespace shellmatch
