#include "geometry/scene/pugixml_node.h"

#include "base/error.h"
#include "base/printable.h"
#include "geometry/mesh_text/read_text.h"

#include <limits>

namespace shellmatch {

namespace {

constexpr std::string_view blanks = " \t\r\n";

std::string_view next(std::string_view& rest) { return next_word(rest, blanks); }

}  // namespace

void parse_xml(const std::string& path, std::string_view bytes, pugi::xml_document& document) {
  const pugi::xml_parse_result result = document.load_buffer(bytes.data(), bytes.size());
  if (result) return;
  throw_input_error("{}: no XML at byte {} ({}); the file is damaged or was cut off", path, result.offset,
                    result.description());
}

std::string_view local_name(const char* name) {
  const std::string_view whole(name);
  return whole.substr(whole.find(':') + 1);
}

pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_node& child : node.children())
    if (local_name(child) == name) return child;
  return {};
}

std::string_view attribute_of(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute& attribute : node.attributes())
    if (local_name(attribute.name()) == name) return attribute.value();
  return {};
}

std::vector<pugi::xml_node> children_of(const pugi::xml_node& node, std::string_view name) {
  std::vector<pugi::xml_node> found;
  for (const pugi::xml_node& child : node.children())
    if (local_name(child) == name) found.push_back(child);
  return found;
}

std::vector<double> numbers_in(const std::string& path, std::string_view text, std::string_view what) {
  std::vector<double> numbers;
  for (std::string_view word = next(text); !word.empty(); word = next(text)) {
    const std::optional<double> number = to_double(word);
    if (!number) throw_input_error("{}: '{}' is no number, in {}", path, printable(word, 30), what);
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<Index> indices_in(const std::string& path, std::string_view text, std::string_view what) {
  std::vector<Index> indices;
  for (std::string_view word = next(text); !word.empty(); word = next(text)) {
    const std::optional<std::int64_t> number = to_integer(word);
    if (!number || *number < 0 || *number > std::numeric_limits<Index>::max())
      throw_input_error("{}: '{}' is no number of a vertex, in {}", path, printable(word, 30), what);
    indices.push_back(static_cast<Index>(*number));
  }
  return indices;
}

}  // namespace shellmatch
