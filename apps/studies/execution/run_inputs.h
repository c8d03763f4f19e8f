#pragma once
/// \file
/// What the result of a run depends on: the experiment, wherever its files are, and their contents.

#include "matching/experiment/options.h"

#include <map>
#include <string>

namespace shellmatch {

/// Checksums of input files, each of which is read once for all runs.
class RunInputs {
 public:
  /// Those of all inputs of an experiment. \param where the beginning of messages \throws InputError for a
  /// file that is missing
  std::string of(const ExperimentOptions& options, const std::string& where);

 private:
  const std::string& checksum_of_shape(const std::string& source, const std::string& where);
  const std::string& checksum_of_file(const std::string& file, const std::string& where);

  std::map<std::string, std::string> known_;
};

/// The experiment with names of files in place of their paths, as YAML.
std::string portable_yaml(ExperimentOptions options);

/// \param inputs as RunInputs gives them
std::string fingerprint_of(const ExperimentOptions& options, const std::string& inputs);

}  // namespace shellmatch
