#include "apps/studies/description/option_file.h"

#include "base/error.h"
#include "base/printable.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/option_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace shellmatch {

OptionFile::OptionFile(std::string path)
    : path_(std::move(path)),
      folder_(std::filesystem::path(path_).parent_path()),
      document_(YamlDocument::from_file(path_).tree()),
      experiment_tree_(option_tree(experiment_)) {}

const YamlValue* OptionFile::find(std::string_view key) const {
  for (const auto& [name, value] : document_.entries)
    if (name == key) return &value;
  return nullptr;
}

void OptionFile::check_version(int known, std::string_view what, std::string_view page) const {
  const YamlValue* version = find("version");
  if (version == nullptr || version->text == std::to_string(known)) return;
  throw_input_error("{}: is {}, and this program reads version {} of {} files only; {} describes it",
                    at(*version, "version"), version->flow_text().empty() ? "empty" : version->flow_text(), known, what,
                    page);
}

void OptionFile::require_version(int known) const {
  if (find("version") == nullptr)
    throw_input_error("{}: version is missing; expected version: {} at the top", path_, known);
}

void OptionFile::set_folder(const std::string& folder) {
  folder_ = folder;
  if (!folder_.is_absolute())
    throw_input_error("{}: folder: {} is no absolute path, one that begins with /", path_, printable(folder));
}

std::string OptionFile::source_of(const std::string& name) const {
  return is_generated_source(name) ? name : path_of(name);
}

std::string OptionFile::at(const YamlValue& value, const std::string& key) const {
  return fmt::format("{}:{}: {}", path_, value.line, key);
}

void OptionFile::demand_map(const YamlValue& value, const std::string& key, const char* expected) const {
  if (value.kind != YamlValue::Kind::map)
    throw_input_error("{}: {}; expected {}", at(value, key),
                      value.kind == YamlValue::Kind::nothing ? "is empty" : "is no section", expected);
}

void OptionFile::fill(const OptionNode& root, const OptionNode& section, const YamlValue& values) const {
  for (const auto& [key, value] : values.entries) {
    const auto option = std::find_if(section.children.begin(), section.children.end(),
                                     [&key = key](const OptionNode& child) { return child.name == key; });
    if (option == section.children.end())
      throw_input_error("{}{}", at(value, ""), unknown_key_text(root, section, key));
    if (option->kind == OptionKind::section) {
      if (option->children.empty()) continue;  // a section whose keys the user chooses
      demand_map(value, option->path, "a section");
      fill(root, *option, value);
    } else {
      const std::string text = option->kind == OptionKind::text && !option->is_list ? value.text : value.flow_text();
      option->set(parse_value(*option, text, at(value, option->path)));
    }
  }
}

void OptionFile::flatten(const YamlValue& section, const std::string& key, const std::string& prefix,
                         std::vector<Override>& changes) const {
  demand_map(section, key, "options of an experiment, as cascade: {max_level: 6}");
  for (const auto& [name, value] : section.entries) {
    const std::string option = prefix.empty() ? name : prefix + "." + name;
    if (value.kind == YamlValue::Kind::map) flatten(value, key, option, changes);
    else changes.push_back(change(value, key, option));
  }
}

Override OptionFile::change(const YamlValue& value, const std::string& key, const std::string& option) const {
  const OptionNode* node = find_option(experiment_tree_, option);
  const bool to_the_letter =
      node != nullptr && node->kind == OptionKind::text && !node->is_list && value.kind == YamlValue::Kind::scalar;
  return beside_file({option, to_the_letter ? value.text : value.flow_text(), at(value, key)}, folder_ / "file.yaml");
}

std::vector<Override> OptionFile::list(const YamlValue& value, const std::string& key,
                                       const std::string& option) const {
  if (value.kind != YamlValue::Kind::list || value.items.empty())
    throw_input_error("{}: {}; expected a list of values of {}", at(value, key),
                      value.kind == YamlValue::Kind::list ? "is an empty list" : "is no list", option);
  std::vector<Override> values;
  for (const YamlValue& item : value.items) values.push_back(change(item, key, option));
  return values;
}

void OptionFile::check_name(const YamlValue& value, const std::string& key, const std::string& name) const {
  const auto good = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (name.empty() || name.size() > 60 || !std::all_of(name.begin(), name.end(), good))
    throw_input_error("{}: the name '{}' cannot be used; expected letters, digits and '_', at most 60", at(value, key),
                      name.substr(0, 80));
}

}  // namespace shellmatch
