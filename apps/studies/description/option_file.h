#pragma once
/// \file
/// The YAML file of a study or a cohort: options of its own, options of experiments, and names that the user
/// chooses.

#include "matching/experiment/option_tree.h"
#include "matching/experiment/options.h"
#include "matching/experiment/yaml_document.h"
#include "matching/experiment/yaml_options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace shellmatch {

/// A section whose keys are names chosen by the user.
struct FreeSection {
  static void describe(auto&, auto&) {}
};

/// Reads the parts of such a file. Every message begins with file, line and key.
class OptionFile {
 public:
  /// \throws InputError as YamlDocument
  explicit OptionFile(std::string path);

  const YamlValue& document() const { return document_; }
  /// The value of a key at the top; null where there is none.
  const YamlValue* find(std::string_view key) const;

  /// The version is checked before all else, since the keys of another one may have other meanings. \param
  /// page that describes the file
  void check_version(int known, std::string_view what, std::string_view page) const;
  /// \throws InputError where the file does not say its version
  void require_version(int known) const;

  /// Relative paths are relative to the file's folder, or to this one. \throws InputError where it is no
  /// absolute path
  void set_folder(const std::string& folder);
  std::string path_of(const std::string& name) const { return (folder_ / name).lexically_normal().string(); }
  /// The source of a shape, which may be a built-in one and have labels.
  std::string source_of(const std::string& name) const;

  /// "FILE:LINE: KEY", the beginning of messages.
  std::string at(const YamlValue& value, const std::string& key) const;
  void demand_map(const YamlValue& value, const std::string& key, const char* expected) const;

  /// Sets the options of `section` from the file; sections whose keys the user chooses are left out.
  void fill(const OptionNode& root, const OptionNode& section, const YamlValue& values) const;

  /// The options of an experiment, in nested sections or with dotted keys, as overrides in their order.
  void flatten(const YamlValue& section, const std::string& key, const std::string& prefix,
               std::vector<Override>& changes) const;
  /// One option of an experiment. \param key in the file \param option its path
  Override change(const YamlValue& value, const std::string& key, const std::string& option) const;
  /// The values of an option in a list.
  std::vector<Override> list(const YamlValue& value, const std::string& key, const std::string& option) const;

  /// Names become parts of the names of files and of runs, in which hyphens separate the parts.
  void check_name(const YamlValue& value, const std::string& key, const std::string& name) const;

 private:
  std::string path_;
  std::filesystem::path folder_;
  YamlValue document_;
  ExperimentOptions experiment_;
  OptionNode experiment_tree_;
};

}  // namespace shellmatch
