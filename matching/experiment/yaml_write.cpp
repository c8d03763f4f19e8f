#include "matching/experiment/option_text.h"
#include "matching/experiment/yaml_options.h"

#include <fmt/format.h>

#include <ostream>

namespace shellmatch {

namespace {

// Unit and range of an option, as "[levels, 1 <= x <= 12]"; empty if it has neither.
std::string limits_text(const OptionNode& option) {
  std::string text(option.info.unit);
  if (option.kind == OptionKind::integer || option.kind == OptionKind::real)
    if (const std::string range = range_text(option.info); range != "any") text += (text.empty() ? "" : ", ") + range;
  return text;
}

std::string any_value_text(const OptionNode& section, const OptionNode& option) {
  return option.level_overrides != nullptr ? level_overrides_text(section, *option.level_overrides)
                                           : value_text(option);
}

void write_section(std::string& text, const OptionNode& section, int depth, bool with_comments) {
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  for (const OptionNode& option : section.children) {
    if (option.kind == OptionKind::section) {
      if (with_comments) text += fmt::format("\n{}# {}\n", indent, option.info.meaning);
      text += fmt::format("{}{}:\n", indent, option.name);
      write_section(text, option, depth + 1, with_comments);
      continue;
    }
    if (with_comments) {
      const std::string limits = limits_text(option);
      text += fmt::format("{}# {} ({}{}{})\n", indent, option.info.meaning, type_text(option),
                          limits.empty() ? "" : ", ", limits);
    }
    text += fmt::format("{}{}: {}\n", indent, option.name, any_value_text(section, option));
  }
}

// Escapes bars, which would end the cell of a table.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c;
  }
  return result;
}

// The values that an option takes, and their unit.
std::string values_text(const OptionNode& option) {
  const bool is_integer = option.kind == OptionKind::integer;
  if (!is_integer && option.kind != OptionKind::real) return type_text(option);
  const std::string range = range_text(option.info);
  std::string text = range == "any" ? type_text(option) : (is_integer ? "integer, " : "") + range;
  if (!option.info.unit.empty()) text += fmt::format(" ({})", option.info.unit);
  return text;
}

// `section` is that which has the option.
void write_rows(std::string& text, const OptionNode& section, const OptionNode& option) {
  if (option.kind != OptionKind::section)
    text += fmt::format("| `{}` | `{}` | {} | {} |\n", option.path, any_value_text(section, option),
                        cell(values_text(option)), cell(option.info.meaning));
  for (const OptionNode& child : option.children) write_rows(text, option, child);
}

constexpr std::string_view table_head = "\n| option | default | values | meaning |\n|---|---|---|---|\n";

// A table of the options that stand in no section, and one of each section.
void write_tables(std::string& text, const OptionNode& root) {
  text += fmt::format("## General\n{}", table_head);
  for (const OptionNode& option : root.children)
    if (option.kind != OptionKind::section) write_rows(text, root, option);
  for (const OptionNode& section : root.children) {
    if (section.kind != OptionKind::section) continue;
    text += fmt::format("\n## {}: {}\n{}", section.name, section.info.meaning, table_head);
    write_rows(text, root, section);
  }
}

}  // namespace

std::string yaml_text(const OptionNode& root, bool with_comments) {
  std::string text;
  write_section(text, root, 0, with_comments);
  return text;
}

std::string changed_yaml_text(const OptionNode& root, const OptionNode& defaults, int depth) {
  const std::string indent(2 * static_cast<std::size_t>(depth), ' ');
  std::string text;
  for (std::size_t k = 0; k < root.children.size(); ++k) {
    const OptionNode &option = root.children[k], &before = defaults.children[k];
    if (option.kind == OptionKind::section) {
      if (const std::string inner = changed_yaml_text(option, before, depth + 1); !inner.empty())
        text += fmt::format("{}{}:\n{}", indent, option.name, inner);
    } else if (const std::string value = any_value_text(root, option); value != any_value_text(defaults, before)) {
      text += fmt::format("{}{}: {}\n", indent, option.name, value);
    }
  }
  return text;
}

std::string to_yaml(const ExperimentOptions& options) {
  ExperimentOptions copy = options;
  return yaml_text(option_tree(copy), false);
}

void print_reference(std::ostream& out, Profile profile, ReferenceFormat format) {
  ExperimentOptions options = profile_defaults(profile);
  const OptionNode root = option_tree(options);
  std::string text;
  if (format == ReferenceFormat::yaml) {
    text = fmt::format("# Every option of shellmatch with the defaults of the profile '{}'.\n", enum_name(profile));
    text += yaml_text(root, true);
  } else {
    write_tables(text, root);
  }
  out << text;
}

}  // namespace shellmatch
