#include "apps/studies/execution/run_inputs.h"

#include "base/error.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/yaml_options.h"
#include "matching/input/shape_source.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/checksum.h"

#include <filesystem>

namespace shellmatch {

const std::string& RunInputs::checksum_of_shape(const std::string& source, const std::string& where) {
  const auto [entry, is_new] = known_.try_emplace(source);
  if (!is_new || source.empty()) return entry->second;
  try {
    if (is_generated_source(source)) check_generated_source(source);
    else
      for (const std::string& file : files_of_shape(source)) entry->second += file_checksum(file);
  } catch (const InputError& error) {
    known_.erase(entry);
    throw_input_error("{}: {}", where, error.what());
  }
  return entry->second;
}

const std::string& RunInputs::checksum_of_file(const std::string& file, const std::string& where) {
  const auto [entry, is_new] = known_.try_emplace("file " + file);
  if (!is_new || file.empty()) return entry->second;
  try {
    entry->second = file_checksum(file);
  } catch (const InputError& error) {
    known_.erase(entry);
    throw_input_error("{}: {}", where, error.what());
  }
  return entry->second;
}

std::string RunInputs::of(const ExperimentOptions& options, const std::string& where) {
  std::string text;
  for (const std::string* source :
       {&options.input.reference, &options.input.template_file, &options.input.correspondence})
    text += "\n" + checksum_of_shape(*source, where);
  for (const std::string* file : {&options.landmarks.file, &options.landmarks.template_file})
    if (!file->empty()) text += "\n" + checksum_of_file(files_of_shape(*file).front(), where);
  if (const std::string& map = options.start.map; !map.empty())
    text +=
        "\n" + checksum_of_file(std::filesystem::is_directory(map) ? map + "/" + deformation_file_name : map, where);
  // As the run reads them.
  for (const std::string& folder : options.start.images)
    for (const char* name : {"deformed.ply", "deformed.csv"})
      if (const std::string file = folder + "/" + name; std::filesystem::exists(file))
        text += "\n" + checksum_of_file(file, where);
  return text;
}

std::string portable_yaml(ExperimentOptions o) {
  for (std::string* source : {&o.input.reference, &o.input.template_file, &o.input.correspondence, &o.landmarks.file,
                              &o.landmarks.template_file, &o.start.map})
    if (!is_generated_source(*source)) *source = std::filesystem::path(*source).filename().string();
  for (std::string& folder : o.start.images) folder = std::filesystem::path(folder).filename().string();
  return to_yaml(o);
}

std::string fingerprint_of(const ExperimentOptions& options, const std::string& inputs) {
  return text_checksum(portable_yaml(options) + inputs);
}

}  // namespace shellmatch
