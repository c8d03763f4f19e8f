#include "geometry/vtk_xml/xml_head.h"

#include <algorithm>
#include <cctype>

namespace shellmatch {

namespace {

constexpr std::string_view xml_blanks = " \t\r\n";
// Keys are compared pair by pair.
constexpr std::size_t max_attributes = 100;

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("_-.:").find(c) != std::string_view::npos;
}

std::string_view take_name(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_name_character);
  const std::string_view name = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(name.size());
  return name;
}

bool take(std::string_view& text, std::string_view part) {
  if (!text.starts_with(part)) return false;
  text.remove_prefix(part.size());
  return true;
}

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(xml_blanks), text.size()));
}

// Takes KEY="VALUE"; false where there is none.
bool take_attribute(std::string_view& text, XmlTag& tag) {
  const std::string_view key = take_name(text);
  skip_blanks(text);
  if (key.empty() || tag.attributes.size() == max_attributes || tag.find(key) || !take(text, "=")) return false;
  skip_blanks(text);
  if (!take(text, "\"")) return false;
  const std::size_t end = text.find('"');
  if (end == text.npos) return false;
  const std::string_view value = text.substr(0, end);
  if (value.find_first_of("<&") != value.npos) return false;
  tag.attributes.emplace_back(key, value);
  text.remove_prefix(end + 1);
  return true;
}

}  // namespace

std::optional<std::string_view> XmlTag::find(std::string_view key) const {
  for (const auto& [own_key, value] : attributes)
    if (own_key == key) return value;
  return std::nullopt;
}

std::optional<XmlTag> next_tag(std::string_view& text) {
  for (;;) {
    text.remove_prefix(std::min(text.find('<'), text.size()));
    const bool declares = text.starts_with("<?"), comments = text.starts_with("<!--");
    if (!declares && !comments) break;
    const std::string_view closing = declares ? "?>" : "-->";
    const std::size_t end = text.find(closing);
    if (end == text.npos) return std::nullopt;
    text.remove_prefix(end + closing.size());
  }
  std::string_view rest = text;
  if (!take(rest, "<")) return std::nullopt;
  XmlTag tag;
  tag.closes = take(rest, "/");
  tag.name = take_name(rest);
  if (tag.name.empty()) return std::nullopt;
  for (;;) {
    skip_blanks(rest);
    if (take(rest, ">")) break;
    if (take(rest, "/>")) {
      tag.is_complete = true;
      break;
    }
    if (tag.closes || !take_attribute(rest, tag)) return std::nullopt;
  }
  if (tag.closes && tag.is_complete) return std::nullopt;
  text = rest;
  return tag;
}

}  // namespace shellmatch
