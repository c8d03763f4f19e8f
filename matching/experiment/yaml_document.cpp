#include "matching/experiment/yaml_document.h"

#include "base/error.h"
#include "matching/experiment/several_errors.h"
#include "matching/experiment/option_text.h"
#include "matching/experiment/yaml_syntax.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>

namespace shellmatch {

namespace {

std::vector<OptionScalar> parse_node(const OptionNode& option, const YAML::Node& value, const std::string& where) {
  const auto scalar = [&](const YAML::Node& node) {
    if (node.IsNull()) throw_input_error("{}: has no value; expected {}", where, allowed_text(option));
    if (!node.IsScalar())
      throw_input_error("{}: a {} is not allowed here; expected {}", where, node.IsMap() ? "section" : "list",
                        allowed_text(option));
    // yaml-cpp gives plain scalars the tag "?" and quoted ones "!"; any other tag stands in the file.
    if (const std::string& tag = node.Tag(); !tag.empty() && tag != "?" && tag != "!")
      throw_input_error("{}: the tag {} is not allowed; expected {}", where, tag, allowed_text(option));
    return parse_scalar(option, node.Scalar(), node.Tag() == "!", where);
  };
  std::vector<OptionScalar> values;
  if (!option.is_list) return {scalar(value)};
  if (value.IsScalar() && option.kind == OptionKind::text) return {scalar(value)};  // a scalar is a list of one text
  if (!value.IsSequence()) throw_input_error("{}: a list is missing; expected {}", where, allowed_text(option));
  for (const YAML::Node& element : value) values.push_back(scalar(element));
  return values;
}

// `budget` is decremented with every value, because aliases may expand without bound or refer to themselves.
YamlValue copy_of(const YAML::Node& node, const std::string& name, int& budget, int depth = 0) {
  YamlValue value;
  value.line = node.Mark().line + 1;
  if (--budget < 0 || depth > 50) throw_input_error("{}:{}: the document unfolds to too many values", name, value.line);
  if (const std::string& tag = node.Tag(); !tag.empty() && tag != "?" && tag != "!")
    throw_input_error("{}:{}: the tag {} is not allowed", name, value.line, tag);
  if (node.IsScalar()) {
    value.kind = YamlValue::Kind::scalar;
    value.text = node.Scalar();
    value.quoted = node.Tag() == "!";
  } else if (node.IsSequence()) {
    value.kind = YamlValue::Kind::list;
    for (const YAML::Node& item : node) value.items.push_back(copy_of(item, name, budget, depth + 1));
  } else if (node.IsMap()) {
    value.kind = YamlValue::Kind::map;
    for (const auto& entry : node) {
      const int line = entry.first.Mark().line + 1;
      if (!entry.first.IsScalar()) throw_input_error("{}:{}: a key must be a word", name, line);
      const std::string& key = entry.first.Scalar();
      for (const auto& [other, earlier] : value.entries)
        if (other == key)
          throw_input_error("{}:{}: {} stands in line {} already; keep one of them", name, line, key, earlier.line);
      YamlValue copy = copy_of(entry.second, name, budget, depth + 1);
      copy.line = line;
      value.entries.emplace_back(key, std::move(copy));
    }
  }
  return value;
}

}  // namespace

YamlValue::YamlValue() = default;
YamlValue::YamlValue(const YamlValue&) = default;
YamlValue::YamlValue(YamlValue&&) noexcept = default;
YamlValue& YamlValue::operator=(const YamlValue&) = default;
YamlValue& YamlValue::operator=(YamlValue&&) noexcept = default;
YamlValue::~YamlValue() = default;

std::string YamlValue::flow_text() const {
  if (kind == Kind::nothing) return "";
  if (kind == Kind::scalar) return quoted ? scalar_text(text, OptionKind::text) : text;
  std::string joined;
  for (const YamlValue& item : items) joined += (joined.empty() ? "" : ", ") + item.flow_text();
  for (const auto& [key, value] : entries) joined += (joined.empty() ? "" : ", ") + key + ": " + value.flow_text();
  return kind == Kind::list ? "[" + joined + "]" : "{" + joined + "}";
}

struct YamlDocument::Content {
  std::string name;
  YAML::Node top;
  std::map<std::string, int> lines;  // lines of the keys set so far, by path, counted from 1

  std::string place(const std::string& path) const {
    const auto line = lines.find(path);
    return line == lines.end() ? fmt::format("{}: {}", name, path) : fmt::format("{}:{}: {}", name, line->second, path);
  }

  void fill_option(const YAML::Node& value, const OptionNode& option) {
    option.set(parse_node(option, value, place(option.path)));
  }

  std::vector<std::string> mistakes;  // of the entries filled so far

  void fill_section(const YAML::Node& map, const OptionNode& root, const OptionNode& section);
  void fill_entry(const YAML::Node& key_node, const YAML::Node& value, const OptionNode& root,
                  const OptionNode& section);
  void fill_levels(const YAML::Node& map, const OptionNode& section, const OptionNode& option);
  void fill_settings(const YAML::Node& map, const OptionNode& section, const std::string& entry_path,
                     const std::string& prefix, LevelOverrides::Entry& entry);

  /// Records the line of a key. \throws InputError if it has been recorded before
  void note_line(const std::string& path, int line) {
    const auto [earlier, is_new] = lines.try_emplace(path, line);
    if (!is_new)
      throw_input_error("{}:{}: {}: the same key stands in line {} already; keep one of them", name, line, path,
                        earlier->second);
  }
};

void YamlDocument::Content::fill_levels(const YAML::Node& map, const OptionNode& section, const OptionNode& option) {
  const std::string where = place(option.path);
  if (!map.IsMap()) throw_input_error("{}: expected {}", where, allowed_text(option));
  for (const auto& entry : map) {
    const int line = entry.first.Mark().line + 1;
    if (!entry.first.IsScalar()) throw_input_error("{}: a key must be a range of levels, as 3-5", where);
    const std::string path = option.path + "." + entry.first.Scalar();
    note_line(path, line);
    LevelOverrides::Entry& levels =
        option.level_overrides->at(entry.first.Scalar(), fmt::format("{}:{}: {}", name, line, option.path));
    if (!entry.second.IsMap())
      throw_input_error("{}: expected options of {}, as {{name: lbfgs}}", place(path), section.path);
    fill_settings(entry.second, section, path, "", levels);
  }
}

// A key is either a name within its section or a dotted path.
void YamlDocument::Content::fill_settings(const YAML::Node& map, const OptionNode& section,
                                          const std::string& entry_path, const std::string& prefix,
                                          LevelOverrides::Entry& entry) {
  for (const auto& setting : map) {
    const int line = setting.first.Mark().line + 1;
    if (!setting.first.IsScalar()) throw_input_error("{}:{}: {}: a key must be a word", name, line, entry_path);
    const std::string path = prefix + setting.first.Scalar(), full_path = entry_path + "." + path;
    note_line(full_path, line);
    const OptionNode* option = overridable_option(section, path, fmt::format("{}:{}: {}", name, line, entry_path));
    if (option->kind != OptionKind::section) {
      entry.set(path, parse_node(*option, setting.second, place(full_path)));
    } else if (setting.second.IsMap()) {
      fill_settings(setting.second, section, entry_path, path + ".", entry);
    } else {
      throw_input_error("{}: is no section; expected some of its keys with values", place(full_path));
    }
  }
}

void YamlDocument::Content::fill_section(const YAML::Node& map, const OptionNode& root, const OptionNode& section) {
  for (const auto& entry : map) {
    try {
      fill_entry(entry.first, entry.second, root, section);
    } catch (const InputError& mistake) {
      mistakes.emplace_back(mistake.what());
    }
  }
}

void YamlDocument::Content::fill_entry(const YAML::Node& key_node, const YAML::Node& value, const OptionNode& root,
                                       const OptionNode& section) {
  const int line = key_node.Mark().line + 1;
  if (!key_node.IsScalar())
    throw_input_error("{}:{}: {}: a key must be a word", name, line,
                      section.path.empty() ? "at the top" : section.path);
  const std::string& key = key_node.Scalar();
  const auto option = std::find_if(section.children.begin(), section.children.end(),
                                   [&](const OptionNode& child) { return child.name == key; });
  if (option == section.children.end())
    throw_input_error("{}:{}: {}", name, line, unknown_key_text(root, section, key));
  note_line(option->path, line);
  if (option->kind == OptionKind::level_overrides) {
    fill_levels(value, section, *option);
  } else if (option->kind != OptionKind::section) {
    fill_option(value, *option);
  } else if (value.IsMap()) {
    fill_section(value, root, *option);
  } else {
    std::vector<std::string> names;
    for (const OptionNode& child : option->children) names.push_back(child.name);
    throw_input_error("{}: {}; expected a section with some of the keys {}", place(option->path),
                      value.IsNull() ? "the section is empty" : "is no section", fmt::join(names, ", "));
  }
}

YamlDocument::YamlDocument(std::unique_ptr<Content> content) : content_(std::move(content)) {}
YamlDocument::YamlDocument(YamlDocument&&) noexcept = default;
YamlDocument::~YamlDocument() = default;

YamlDocument YamlDocument::from_file(const std::string& path) { return from_text(read_yaml_file(path), path); }

YamlDocument YamlDocument::from_text(const std::string& text, const std::string& name) {
  return YamlDocument(std::make_unique<Content>(Content{name, parse_yaml_map(text, name), {}, {}}));
}

std::string YamlDocument::place(const std::string& path) const { return content_->place(path); }

YamlValue YamlDocument::tree() const {
  int budget = 20000;
  return copy_of(content_->top, content_->name, budget);
}

void YamlDocument::fill_one(const OptionNode& root, const std::string& key) {
  for (const auto& entry : content_->top)
    if (entry.first.IsScalar() && entry.first.Scalar() == key) {
      content_->lines[key] = entry.first.Mark().line + 1;
      return content_->fill_option(entry.second, *find_option(root, key));
    }
}

void YamlDocument::fill(const OptionNode& root) {
  constexpr std::size_t most_told = 10;
  content_->lines.clear();
  content_->mistakes.clear();
  content_->fill_section(content_->top, root, root);
  std::vector<std::string> mistakes = std::move(content_->mistakes);
  if (mistakes.empty()) return;
  if (mistakes.size() == 1) throw InputError(mistakes.front());
  if (const std::size_t n = mistakes.size(); n > most_told) {
    mistakes.resize(most_told);
    mistakes.push_back(fmt::format("{}: {} mistakes more", content_->name, n - most_told));
  }
  throw SeveralInputErrors(std::move(mistakes));
}

std::vector<OptionScalar> parse_value(const OptionNode& option, const std::string& text, const std::string& where) {
  if (option.kind == OptionKind::text && !option.is_list) return {text};
  try {
    if (const auto column = column_after_value(text))
      throw_input_error("{}: the value ends before column {}, and something follows; expected {}", where, *column,
                        allowed_text(option));
    return parse_node(option, YAML::Load(text), where);
  } catch (const YAML::Exception& error) {
    throw_input_error("{}: {} (column {}); expected {}", where, error.msg, error.mark.column + 1, allowed_text(option));
  }
}

}  // namespace shellmatch
