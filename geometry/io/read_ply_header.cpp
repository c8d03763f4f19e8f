#include "geometry/io/read_ply_header.h"

#include "geometry/surface/space.h"

namespace shellmatch {
namespace {

ValueType known_type(std::string_view name, const LineReader& lines) {
  const std::optional<ValueType> type = ply_type(name);
  if (!type) lines.fail("unknown type of a property; PLY has char, uchar, short, ushort, int, uint, float and double");
  return *type;
}

PlyProperty read_property(LineReader& lines, std::string_view rest) {
  PlyProperty property;
  std::string_view type = next_word(rest);
  if (type == "list") {
    property.is_list = true;
    property.count_type = known_type(next_word(rest), lines);
    type = next_word(rest);
  }
  property.type = known_type(type, lines);
  property.name = next_word(rest);
  if (property.name.empty()) lines.fail("a property needs a name");
  return property;
}

PlyForm read_form(LineReader& lines, std::string_view rest) {
  const std::string_view name = next_word(rest);
  if (name == "ascii") return PlyForm::text;
  if (name == "binary_little_endian") return PlyForm::little_endian;
  if (name == "binary_big_endian") return PlyForm::big_endian;
  lines.fail("the format should be ascii, binary_little_endian or binary_big_endian, not '{}'", name);
}

// Checks the counts against the least number of bytes per item, so that a damaged count causes no huge
// allocation.
void check_size(const PlyHeader& header, const LineReader& lines) {
  for (const PlyElement& element : header.elements) {
    std::size_t item = 0;
    for (const PlyProperty& p : element.properties) {
      if (header.form == PlyForm::text) item += 2;
      else item += bytes_of(p.is_list ? p.count_type : p.type);
    }
    // The last line of a text may lack its end.
    if (item > 0 && element.n_items > (lines.n_left() + 1) / item)
      throw_input_error(
          "{}: cut off, or the header is wrong: it declares {} elements of kind '{}', which do not fit into "
          "the {} bytes that follow",
          lines.path(), element.n_items, element.name, lines.n_left());
  }
}

}  // namespace

PlyHeader read_ply_header(LineReader& lines) {
  PlyHeader header;
  if (!lines.next() || lines.line() != "ply")
    throw_input_error("{}: a PLY file starts with the line 'ply'", lines.path());
  bool form_known = false;
  while (lines.next_line()) {
    std::string_view rest = lines.line();
    const std::string_view keyword = next_word(rest);
    if (keyword == "end_header") {
      if (!form_known) lines.fail("the header does not name the format (ascii or binary)");
      check_size(header, lines);
      return header;
    }
    if (keyword == "format") {
      header.form = read_form(lines, rest);
      form_known = true;
    } else if (keyword == "element") {
      PlyElement element;
      element.name = next_word(rest);
      const std::int64_t n = lines.integer_of(rest, "the number of elements");
      if (n < 0) lines.fail("the number of elements is negative");
      element.n_items = static_cast<std::size_t>(n);
      for (const PlyElement& other : header.elements)
        if (other.name == element.name) lines.fail("the element '{}' is declared twice", element.name);
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      if (header.elements.empty()) lines.fail("a property comes before the first element");
      header.elements.back().properties.push_back(read_property(lines, rest));
    } else if (keyword == "comment" || keyword == "obj_info") {
      if (space_in_comment(lines.line()) == Space::unsaid) header.comments.emplace_back(lines.line());
    } else if (!keyword.empty()) {
      lines.fail("unknown word in the header; a PLY header has format, comment, element, property and end_header");
    }
  }
  throw_input_error("{}: cut off: the header has no end_header", lines.path());
}

std::optional<ValueType> ply_type(std::string_view name) {
  using enum ValueType;
  constexpr std::pair<ValueType, std::string_view> new_names[] = {
      {int8, "int8"},   {uint8, "uint8"},   {int16, "int16"},     {uint16, "uint16"},
      {int32, "int32"}, {uint32, "uint32"}, {float32, "float32"}, {float64, "float64"}};
  for (const auto& [type, new_name] : new_names)
    if (name == column_type(type) || name == new_name) return type;
  return std::nullopt;
}

std::string describe_counts(const PlyHeader& header) {
  std::string text;
  for (const PlyElement& e : header.elements)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", e.n_items, e.name);
  return text;
}

}  // namespace shellmatch
