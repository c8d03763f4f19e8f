#pragma once
/// \file
/// An experiment in YAML: reading, overriding, writing and documenting it. All messages name the file and
/// line or the command line option, the full key, what is allowed and the nearest valid spelling.

#include "matching/experiment/options.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace shellmatch {

/// One option set from outside the file.
struct Override {
  std::string key;     ///< full path, "cascade.nu"
  std::string value;   ///< in YAML's notation; to the letter where the option is text
  std::string origin;  ///< for messages: "--levels 3:7"
};

/// "key.sub=value" as in `--set`. \throws InputError without a key or an equals sign
Override parse_override(const std::string& assignment);

/// `change` as it is meant where it stands in `file`: a relative path of a shape or another input is taken
/// relative to that file; anything else stays.
Override beside_file(Override change, const std::string& file);

/// Reads an experiment. What is set later wins: defaults of the profile, then the file, then `overrides` in
/// their order; the profile itself is the last override of `profile`, else the file's, else default.
/// Relative paths of shapes and other inputs in the file are relative to the file, those in overrides to the working folder;
/// built-in shapes (`generate:...`) are no paths.
/// \throws InputError
ExperimentOptions read_experiment(const std::string& path, const std::vector<Override>& overrides = {});

/// The same without a file.
ExperimentOptions make_experiment(const std::vector<Override>& overrides);

/// Sets one option by "key.sub=value". `profile` is refused, as it decides on all the other defaults: give it
/// to read_experiment. Does not check options against each other. \throws InputError
void apply_override(ExperimentOptions& options, const std::string& assignment);

/// The range of every number, and demands that hold between options, such as max_level >= min_level. \throws InputError
void check_experiment(const ExperimentOptions& options);

/// Paths of shapes and other inputs made absolute, so that the YAML that is written may lie anywhere.
ExperimentOptions with_absolute_paths(ExperimentOptions options);

/// All options, fully resolved. read_experiment gives back the same values to the last bit.
std::string to_yaml(const ExperimentOptions& options);

enum class ReferenceFormat { yaml, markdown };

/// Every option with type, default of the profile, range, unit and meaning: a YAML file with comments that is
/// ready to be edited, or a Markdown table.
void print_reference(std::ostream& out, Profile profile, ReferenceFormat format);

}  // namespace shellmatch
