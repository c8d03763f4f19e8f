#pragma once
/// \file
/// Overrides of an experiment by the options of the command line.

#include "apps/commands.h"
#include "matching/experiment/yaml_options.h"

#include <vector>

namespace shellmatch {

/// The overrides in the order of their application: named options first, so that --set takes precedence.
/// \throws InputError for invalid values
std::vector<Override> overrides_of(const RunSettings& settings);

/// Reads the experiment of a YAML file, with these settings; both shapes must be named. \throws InputError
ExperimentOptions read_run_options(const std::string& config, const RunSettings& settings);

}  // namespace shellmatch
