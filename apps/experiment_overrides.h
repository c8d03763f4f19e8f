#pragma once
/// \file
/// The options of the command line that change an experiment.

#include "apps/commands.h"
#include "matching/experiment/yaml_options.h"

#include <vector>

namespace shellmatch {

/// In the order in which they are to be applied: named options first, so that --set wins over them.
/// \throws InputError for what cannot be understood
std::vector<Override> overrides_of(const RunSettings& settings);

/// The experiment of a YAML file with these settings, both shapes named. \throws InputError
ExperimentOptions read_run_options(const std::string& config, const RunSettings& settings);

}  // namespace shellmatch
