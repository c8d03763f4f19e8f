#pragma once
/// \file
/// Reading, overriding, writing and documenting an experiment in YAML. Messages name the file and line, or the command
/// line option, the full key, the allowed values and the nearest valid spelling.

#include "matching/experiment/options.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace shellmatch {

/// One option that is set outside of the file.
struct Override {
  std::string key;     ///< full path, "cascade.nu"
  std::string value;   ///< in YAML's notation; taken literally for options of free text
  std::string origin;  ///< beginning of messages: "--levels 3:7"
};

/// Parses "key.sub=value" as in `--set`. \throws InputError without a key or an equals sign
Override parse_override(const std::string& assignment);

/// The override for use outside of `file`: relative paths of shapes and other inputs are resolved relative to that
/// file; other values are unchanged.
Override beside_file(Override change, const std::string& file);

/// Reads an experiment. Later settings win: the defaults of the profile, then the file, then `overrides` in their
/// order. The profile is the last override of `profile`, else the file's, else default. Relative paths of inputs are
/// relative to the file, or for overrides to the working folder; built-in shapes (`generate:...`) are no paths.
/// \throws InputError
ExperimentOptions read_experiment(const std::string& path, const std::vector<Override>& overrides = {});

/// An experiment from defaults and overrides alone.
ExperimentOptions make_experiment(const std::vector<Override>& overrides);

/// Sets one option by "key.sub=value". Refuses `profile`, on which all other defaults depend; give that to
/// read_experiment. Does not check conditions between options. \throws InputError
void apply_override(ExperimentOptions& options, const std::string& assignment);
void apply_override(ExperimentOptions& options, const Override& change);

/// Checks the range of every number, and conditions between options, such as max_level >= min_level. \throws InputError
void check_experiment(const ExperimentOptions& options);

/// The options with absolute paths of shapes and other inputs, so that their YAML file can lie anywhere.
ExperimentOptions with_absolute_paths(ExperimentOptions options);

/// All options as YAML. read_experiment reads back the same values bit for bit.
std::string to_yaml(const ExperimentOptions& options);

enum class ReferenceFormat { yaml, markdown };

/// Prints every option with type, default of the profile, range, unit and meaning: as a commented YAML file ready to be
/// edited, or as a Markdown table.
void print_reference(std::ostream& out, Profile profile, ReferenceFormat format);

}  // namespace shellmatch
