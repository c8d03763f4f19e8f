#include "matching/experiment/option_text.h"

#include "base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace shellmatch {

namespace {

// Input texts may have any content; messages quote them on one line of bounded length.
std::string shown(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, 60)) result += static_cast<unsigned char>(c) < 32 ? '?' : c;
  return '"' + result + (text.size() > 60 ? "...\"" : "\"");
}

template <class Number>
std::errc parse_number(std::string_view text, Number& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return error;
  return end == text.data() + text.size() ? std::errc() : std::errc::invalid_argument;
}

[[noreturn]] void refuse(const OptionNode& option, std::string_view text, const std::string& where,
                         const std::string& hint = "") {
  throw_input_error("{}: {} is not allowed here; expected {}{}", where, shown(text), allowed_text(option), hint);
}

void require_range(const OptionNode& option, double value, std::string_view text, const std::string& where) {
  if (in_range(value, option.info)) return;
  throw_input_error("{}: {} is out of range; expected {}", where, text, allowed_text(option));
}

bool parse_boolean(const OptionNode& option, std::string_view text, const std::string& where) {
  if (text == "true") return true;
  if (text == "false") return false;
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const char* word : {"yes", "on", "y", "true", "1"})
    if (lower == word) refuse(option, text, where, "; did you mean true?");
  for (const char* word : {"no", "off", "n", "false", "0"})
    if (lower == word) refuse(option, text, where, "; did you mean false?");
  const std::string near = nearest_word(lower, {"true", "false"});
  refuse(option, text, where, near.empty() ? "" : fmt::format("; did you mean {}?", near));
}

int parse_integer(const OptionNode& option, std::string_view text, const std::string& where) {
  int value = 0;
  const std::errc error = parse_number(text, value);
  if (error == std::errc::result_out_of_range)
    throw_input_error("{}: {} is out of range; expected {}", where, shown(text), allowed_text(option));
  if (error != std::errc()) refuse(option, text, where);
  require_range(option, value, text, where);
  return value;
}

double parse_real(const OptionNode& option, std::string_view text, const std::string& where) {
  double value = 0;
  const std::errc error = parse_number(text, value);
  if (error == std::errc::result_out_of_range)
    throw_input_error("{}: {} is too large or too small for a double; expected {}", where, shown(text),
                      allowed_text(option));
  if (error != std::errc() || !std::isfinite(value)) refuse(option, text, where);
  require_range(option, value, text, where);
  return value;
}

std::string quoted_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += fmt::format("\\{}", c);
    else if (c == '\n') result += "\\n";
    else if (c == '\t') result += "\\t";
    else if (static_cast<unsigned char>(c) < 32 || c == 127) result += fmt::format("\\x{:02x}", c);
    else result += c;
  }
  return result + '"';
}

// Path of an option or section of exactly this name, anywhere in the tree; empty if there is none.
std::string path_of_name(const OptionNode& node, const std::string& name) {
  for (const OptionNode& child : node.children) {
    if (child.name == name) return child.path;
    if (std::string path = path_of_name(child, name); !path.empty()) return path;
  }
  return "";
}

}  // namespace

OptionScalar parse_scalar(const OptionNode& option, std::string_view text, bool quoted, const std::string& where) {
  if (option.kind == OptionKind::text) return std::string(text);
  if (quoted) refuse(option, text, where, ", without quotes");
  switch (option.kind) {
    case OptionKind::boolean: return parse_boolean(option, text, where);
    case OptionKind::integer: return parse_integer(option, text, where);
    case OptionKind::real: return parse_real(option, text, where);
    default: break;
  }
  if (std::find(option.choices.begin(), option.choices.end(), text) == option.choices.end()) {
    const std::string near = nearest_word(text.substr(0, 60), option.choices);
    refuse(option, text, where, near.empty() ? "" : fmt::format("; did you mean {}?", near));
  }
  return std::string(text);
}

std::string scalar_text(const OptionScalar& value, OptionKind kind) {
  if (const bool* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (const int* i = std::get_if<int>(&value)) return fmt::format("{}", *i);
  if (const double* d = std::get_if<double>(&value)) return fmt::format("{}", *d);
  const std::string& text = std::get<std::string>(value);
  return kind == OptionKind::choice ? text : quoted_text(text);
}

std::string level_overrides_text(const OptionNode& section, const LevelOverrides& levels) {
  std::vector<std::string> entries;
  for (const LevelOverrides::Entry& e : levels.entries) {
    std::vector<std::string> settings;
    for (const auto& [path, values] : e.settings) {
      OptionNode option = *find_option(section, path);
      option.get = [&v = values] { return v; };
      settings.push_back(fmt::format("{}: {}", path, value_text(option)));
    }
    entries.push_back(fmt::format("{}: {{{}}}", e.key(), fmt::join(settings, ", ")));
  }
  return fmt::format("{{{}}}", fmt::join(entries, ", "));
}

std::string value_text(const OptionNode& option) {
  std::vector<std::string> texts;
  for (const OptionScalar& value : option.get()) texts.push_back(scalar_text(value, option.kind));
  return option.is_list ? fmt::format("[{}]", fmt::join(texts, ", ")) : texts.front();
}

std::string type_text(const OptionNode& option) {
  std::string name;
  switch (option.kind) {
    case OptionKind::section: return "section";
    case OptionKind::level_overrides: return "map of levels to options";
    case OptionKind::boolean: name = "true | false"; break;
    case OptionKind::integer: name = "integer"; break;
    case OptionKind::real: name = "real number"; break;
    case OptionKind::text: name = "text"; break;
    case OptionKind::choice: name = fmt::format("{}", fmt::join(option.choices, " | ")); break;
  }
  return option.is_list ? fmt::format("list of {}", name) : name;
}

std::string allowed_text(const OptionNode& option) {
  std::string text;
  switch (option.kind) {
    case OptionKind::section: return "a section of keys and values";
    case OptionKind::level_overrides: return "a map from levels to options of its section, as {3-5: {name: lbfgs}}";
    case OptionKind::boolean: text = "true or false"; break;
    case OptionKind::integer: text = "an integer"; break;
    case OptionKind::real: text = "a finite number"; break;
    case OptionKind::text: text = "text"; break;
    case OptionKind::choice: text = fmt::format("one of {}", fmt::join(option.choices, ", ")); break;
  }
  if (option.kind == OptionKind::integer || option.kind == OptionKind::real)
    if (const std::string range = range_text(option.info); range != "any") text += ", " + range;
  return option.is_list ? fmt::format("a list [a, b, ...], each {}", text) : text;
}

const OptionNode* find_option(const OptionNode& root, std::string_view path) {
  const std::size_t dot = path.find('.');
  for (const OptionNode& child : root.children)
    if (child.name == path.substr(0, dot))
      return dot == std::string_view::npos ? &child : find_option(child, path.substr(dot + 1));
  return nullptr;
}

const OptionNode* overridable_option(const OptionNode& section, std::string_view path, const std::string& where) {
  const OptionNode* option = find_option(section, path);
  if (option == nullptr) throw_input_error("{}: {}", where, unknown_key_text(section, section, std::string(path)));
  if (option->kind == OptionKind::level_overrides)
    throw_input_error("{}: {} cannot stand within itself", where, option->name);
  return option;
}

std::string unknown_key_text(const OptionNode& root, const OptionNode& section, const std::string& key) {
  std::vector<std::string> names;
  for (const OptionNode& child : section.children) names.push_back(child.name);
  const std::string place = section.path.empty() ? "" : section.path + ": ";
  std::string text = fmt::format("{}unknown key {}", place, shown(key));
  if (key.size() <= 60) {
    const std::string near = nearest_word(key, names), elsewhere = path_of_name(root, key);
    if (!elsewhere.empty()) text += fmt::format("; did you mean {}?", elsewhere);
    else if (!near.empty())
      text += fmt::format("; did you mean {}{}?", section.path.empty() ? "" : section.path + ".", near);
  }
  return fmt::format("{}{} allowed {}: {}", text, text.ends_with('?') ? "" : ";",
                     section.path.empty() ? "at the top" : "in " + section.path, fmt::join(names, ", "));
}

}  // namespace shellmatch
