#include "geometry/io/read_points.h"

#include "geometry/mesh_text/read_text.h"
#include "geometry/surface/mesh_details.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace shellmatch {
namespace {

constexpr std::string_view separators = " \t,;";

// The next word without the quotes around it.
std::string_view next_value(std::string_view& rest) {
  const std::string_view word = next_word(rest, separators);
  return word.size() > 1 && word.front() == '"' && word.back() == '"' ? word.substr(1, word.size() - 2) : word;
}

std::vector<std::string_view> split(const LineReader& lines) {
  std::string_view rest = lines.line();
  char before = ' ';
  for (const char c : rest) {
    if ((c == ',' || c == ';') && c == before) lines.fail("a column is empty");
    if (c != ' ' && c != '\t') before = c;
  }
  std::vector<std::string_view> words;
  while (rest.find_first_not_of(separators) != rest.npos) words.push_back(next_value(rest));
  return words;
}

// The names in a line, which are those of CSV where there are commas in it.
std::vector<std::string> names_of(const LineReader& lines) {
  std::vector<std::string> names;
  if (lines.line().find(',') == std::string_view::npos) {
    for (const std::string_view word : split(lines)) names.emplace_back(word);
    return names;
  }
  for (const std::string_view field : csv_fields(lines.line())) names.push_back(csv_text(field));
  // Lines may end with a comma.
  if (names.back().empty()) names.pop_back();
  if (std::ranges::find(names, "") != names.end()) lines.fail("a column is empty");
  return names;
}

// For a line of more columns than there are names.
std::string_view comma_advice(const LineReader& lines) {
  const bool has_both =
      lines.line().find(',') != std::string_view::npos && lines.line().find(';') != std::string_view::npos;
  return has_both ? "; if commas are decimal, as in 1,5, write points" : "";
}

// Is it the name of a column that may hold texts?
bool names_texts(std::string_view name) {
  for (const std::string_view known : {"name", "label", "description", "desc"})
    if (equals_ignoring_case(name, known)) return true;
  return false;
}

// The names of the columns, and which of them are coordinates.
template <int Dim>
struct Columns {
  std::array<std::size_t, Dim> coordinates;
  std::vector<std::string> names;
  std::vector<bool> is_text = {};  // may hold texts; if all are numbers, it holds numbers
};

constexpr std::string_view axis_names = "xyz";

template <int Dim>
Columns<Dim> named_columns(const std::vector<std::string>& words, const LineReader& lines) {
  Columns<Dim> columns;
  columns.names = words;
  std::iota(columns.coordinates.begin(), columns.coordinates.end(), std::size_t{0});
  const auto column_of = [&](std::size_t axis) {
    return static_cast<std::size_t>(
        std::find_if(words.begin(), words.end(),
                     [&](std::string_view word) { return equals_ignoring_case(word, axis_names.substr(axis, 1)); }) -
        words.begin());
  };
  if (Dim == 2 && column_of(2) < words.size())
    lines.fail("there is a column z: these are points of space, but an outline in the plane is wanted");
  for (std::size_t axis = 0; axis < Dim; ++axis)
    if (column_of(axis) < words.size()) columns.coordinates[axis] = column_of(axis);
  auto sorted = columns.coordinates;
  std::sort(sorted.begin(), sorted.end());
  if (words.size() < Dim || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    lines.fail("{} columns with coordinates are needed", Dim);
  return columns;
}

template <int Dim>
Columns<Dim> unnamed_columns(std::size_t n_words, const LineReader& lines) {
  if (n_words != Dim)
    lines.fail("{}, but points of {} have {}; further columns need a first line with names{}",
               counted(n_words, "column", "columns"), Dim == 2 ? "the plane" : "space", Dim, comma_advice(lines));
  Columns<Dim> columns;
  std::iota(columns.coordinates.begin(), columns.coordinates.end(), std::size_t{0});
  columns.names.resize(Dim);
  return columns;
}

// A column of numbers, unless one of its texts is none.
VertexAttribute attribute_of(const std::string& name, std::vector<double> values, std::vector<std::string> texts) {
  for (const std::string& text : texts) {
    const std::optional<double> value = to_double(text);
    if (!value) return {name, "text", {}, std::move(texts)};
    values.push_back(*value);
  }
  return {name, "double", std::move(values)};
}

}  // namespace

template <int Dim>
OriginalShape<Dim> read_points(const std::string& path, std::string_view bytes, bool closed) {
  OriginalShape<Dim> shape;
  LineReader lines(path, bytes);
  Columns<Dim> columns;
  std::vector<std::vector<double>> values;
  std::vector<std::vector<std::string>> texts;
  bool is_comma_separated = false, has_names = false;
  std::vector<Index> block;
  const auto end_block = [&] {
    if (closed && block.size() > 1 && shape.vertices[block.front()] == shape.vertices[block.back()]) {
      shape.vertices.pop_back();
      for (auto& column : values)
        if (!column.empty()) column.pop_back();
      for (auto& column : texts)
        if (!column.empty()) column.pop_back();
      block.pop_back();
    }
    if (Dim == 2 && !block.empty()) shape.polygons.push_back(block);
    block.clear();
  };
  while (lines.next_line()) {
    if (lines.line().empty()) {
      if (!lines.only_comment()) end_block();
      continue;
    }
    if (lines.line().find_first_not_of(separators) == std::string_view::npos) lines.fail("separators, but no numbers");
    if (values.empty()) {
      std::string_view rest = lines.line();
      const bool header = has_names = !to_double(next_value(rest));
      columns = header ? named_columns<Dim>(names_of(lines), lines) : unnamed_columns<Dim>(split(lines).size(), lines);
      values.resize(columns.names.size());
      texts.resize(columns.names.size());
      for (const std::string& name : columns.names) columns.is_text.push_back(names_texts(name));
      for (const std::size_t c : columns.coordinates) columns.is_text[c] = false;
      is_comma_separated = values.size() > 1 && csv_fields(lines.line()).size() == values.size();
      if (header) continue;
    }
    // Texts may hold blanks and, in quotes, commas.
    const bool is_first = has_names && shape.vertices.empty();
    const bool has_texts =
        is_comma_separated && (is_first || std::ranges::find(columns.is_text, true) != columns.is_text.end());
    std::vector<std::string_view> words = has_texts ? csv_fields(lines.line()) : std::vector<std::string_view>();
    if (words.size() != values.size()) words = split(lines);
    if (words.size() != values.size())
      lines.fail("{}, the lines above have {}{}", counted(words.size(), "column", "columns"), values.size(),
                 comma_advice(lines));
    // A further column that begins with a text holds texts, whatever its name.
    if (is_comma_separated && is_first)
      for (std::size_t c = 0; c < words.size(); ++c)
        if (std::ranges::find(columns.coordinates, c) == columns.coordinates.end() && !to_double(csv_text(words[c])))
          columns.is_text[c] = true;
    for (std::size_t c = 0; c < words.size(); ++c) {
      if (columns.is_text[c]) {
        texts[c].push_back(csv_text(words[c]));
        continue;
      }
      std::string_view word = words[c];
      values[c].push_back(lines.number_of(word, "a column"));
    }
    Vec<Dim> x;
    for (std::size_t axis = 0; axis < Dim; ++axis) x[static_cast<int>(axis)] = values[columns.coordinates[axis]].back();
    if (!x.allFinite()) lines.fail("the point has a coordinate that is not finite; remove it or give it a position");
    block.push_back(static_cast<Index>(shape.vertices.size()));
    shape.vertices.push_back(x);
  }
  end_block();
  if (shape.vertices.empty()) throw_input_error("{}: no points in it", path);
  if (has_names) {
    auto details = std::make_shared<MeshDetails>();
    details->table_columns = columns.names;
    details->table_coordinates.assign(columns.coordinates.begin(), columns.coordinates.end());
    shape.details = std::move(details);
  }
  for (std::size_t c = 0; c < values.size(); ++c)
    if (std::find(columns.coordinates.begin(), columns.coordinates.end(), c) == columns.coordinates.end())
      shape.attributes.push_back(attribute_of(columns.names[c], std::move(values[c]), std::move(texts[c])));
  return shape;
}

SHELLMATCH_2D_3D(read_points);

}  // namespace shellmatch
