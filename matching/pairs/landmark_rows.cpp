#include "matching/pairs/landmark_rows.h"

#include "base/error.h"
#include "base/stop.h"
#include "base/text.h"
#include "geometry/io/input_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace shellmatch {

namespace {

constexpr std::array axes = {"x", "y", "z"};

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (const std::string_view field : csv_fields(line)) fields.push_back(csv_text(field));
  return fields;
}

/// Checks the head line: every column is known, named once, and no point lacks a coordinate.
template <int Dim>
void check_columns(const LineReader& reader, const std::vector<std::string>& columns,
                   const std::vector<std::string>& suffixes, bool names_needed) {
  std::vector<std::string> known = {"name", "weight", "sd"};
  for (const std::string& suffix : suffixes) {
    known.push_back("vertex" + suffix);
    for (int k = 0; k < Dim; ++k) known.push_back(axes[static_cast<std::size_t>(k)] + suffix);
  }
  const auto has = [&](const std::string& name) {
    return std::find(columns.begin(), columns.end(), name) != columns.end();
  };
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (std::find(known.begin(), known.end(), columns[i]) == known.end())
      reader.fail("unknown column '{}'; of a {}-dimensional shape expected a head line with some of {}", columns[i],
                  Dim, fmt::format("{}", fmt::join(known, ",")));
    if (std::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(i), columns[i]) !=
        columns.begin() + static_cast<std::ptrdiff_t>(i))
      reader.fail("two columns are named '{}'", columns[i]);
  }
  for (const std::string& suffix : suffixes) {
    if (has("vertex" + suffix)) {
      for (int k = 0; k < Dim; ++k)
        if (const std::string name = axes[static_cast<std::size_t>(k)] + suffix; has(name))
          reader.fail("'vertex{}' and '{}' exclude each other: both say where a point is", suffix, name);
      continue;
    }
    for (int k = 0; k < Dim; ++k)
      if (const std::string name = axes[static_cast<std::size_t>(k)] + suffix; !has(name))
        reader.fail("there is no column '{}'; too few columns for a point in {} dimensions, and no 'vertex{}'", name,
                    Dim, suffix);
  }
  if (names_needed && !has("name"))
    reader.fail("there is no column 'name', by which points of two files belong together");
  if (has("weight") && has("sd")) reader.fail("'weight' and 'sd' exclude each other");
}

}  // namespace

LandmarkRow::LandmarkRow(const LineReader& reader, const std::vector<std::string>& columns,
                         std::vector<std::string> fields)
    : reader_(reader), columns_(columns), fields_(std::move(fields)) {
  if (fields_.size() != columns_.size())
    reader.fail("{} values where the head line has {} columns ({})", fields_.size(), columns_.size(),
                fmt::format("{}", fmt::join(columns_, ",")));
}

const std::string* LandmarkRow::find(std::string_view column) const {
  const auto at = std::find(columns_.begin(), columns_.end(), column);
  return at == columns_.end() ? nullptr : &fields_[static_cast<std::size_t>(at - columns_.begin())];
}

double LandmarkRow::number(std::string_view column) const {
  const std::string& text = *find(column);
  const std::optional<double> value = to_double(text);
  if (!value || !std::isfinite(*value)) reader_.fail("{} is '{}'; expected a number", column, text);
  return *value;
}

double LandmarkRow::positive(std::string_view column) const {
  const double value = number(column);
  if (!(value > 0)) reader_.fail("{} is {}; expected a number > 0", column, value);
  constexpr double least = 1e-50, most = 1e50;
  if (!(value >= least && value <= most))
    reader_.fail("{} is {}; expected a number from {:g} to {:g}", column, value, least, most);
  return value;
}

template <int Dim>
Vec<Dim> LandmarkRow::point(const std::string& suffix, const std::vector<Vec<Dim>>& vertices, Space from, Space to,
                            const PlaneFrame& frame) const {
  const std::string vertex = "vertex" + suffix;
  if (const std::string* text = find(vertex)) {
    const auto index = to_integer(*text);
    if (!index) reader_.fail("{} is '{}'; expected the index of a vertex, counted from 0", vertex, *text);
    if (*index < 0 || static_cast<std::size_t>(*index) >= vertices.size())
      reader_.fail("{} is {}; that shape has {} vertices, counted from 0", vertex, *index, vertices.size());
    return vertices[static_cast<std::size_t>(*index)];
  }
  Vec<Dim> x;
  for (int k = 0; k < Dim; ++k) x[k] = number(axes[static_cast<std::size_t>(k)] + suffix);
  if constexpr (Dim == 3) return in_space(x, from, to);
  return frame(x);
}

template <int Dim>
bool LandmarkRow::is_missing(const std::string& suffix) const {
  if (find("vertex" + suffix)) return false;
  for (int k = 0; k < Dim; ++k) {
    const std::string& text = *find(axes[static_cast<std::size_t>(k)] + suffix);
    if (!text.empty() && !equals_ignoring_case(text, "na") && !equals_ignoring_case(text, "nan")) return false;
  }
  return true;
}

std::string LandmarkRow::place() const { return fmt::format("{}, line {}", reader_.path(), reader_.number()); }

template <int Dim>
void for_each_landmark_row(const std::string& path, const std::vector<std::string>& suffixes, bool names_needed,
                           const std::function<void(const LandmarkRow&, const std::string& name)>& body) {
  const std::string text = InputFile(path).read();
  LineReader reader(path, text);
  if (!reader.next())
    throw_input_error("{}: holds no landmark; expected a head line with the names of the columns", path);
  std::vector<std::string> columns = fields_of(reader.line());
  for (std::string& column : columns)
    for (const std::string_view known : {"name", "label"})
      if (equals_ignoring_case(column, known)) column = "name";
  check_columns<Dim>(reader, columns, suffixes, names_needed);
  std::map<std::string, std::size_t> line_of;
  while (reader.next()) {
    if (reader.number() % 1024 == 0) stop_if_wanted();
    const LandmarkRow row(reader, columns, fields_of(reader.line()));
    const std::string* given = row.find("name");
    const std::string name = given ? *given : fmt::format("line {}", reader.number());
    if (name.empty()) reader.fail("the name is empty");
    if (const auto [at, is_new] = line_of.emplace(name, reader.number()); !is_new)
      reader.fail("the name '{}' stands in line {} already", name, at->second);
    body(row, name);
  }
  if (line_of.empty()) throw_input_error("{}: holds no landmark besides its head line", path);
}

SHELLMATCH_2D_3D(for_each_landmark_row);
#define SHELLMATCH_INSTANTIATE(Dim)                                                                         \
  template bool LandmarkRow::is_missing<Dim>(const std::string&) const;                                     \
  template Vec<Dim> LandmarkRow::point<Dim>(const std::string&, const std::vector<Vec<Dim>>&, Space, Space, \
                                            const PlaneFrame&) const;
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
