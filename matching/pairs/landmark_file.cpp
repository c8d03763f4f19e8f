#include "matching/pairs/landmark_file.h"

#include "base/error.h"
#include "geometry/io/input_file.h"
#include "geometry/io/read_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

namespace shellmatch {

namespace {

constexpr std::array axes = {"x", "y", "z"};

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    std::string_view field = line.substr(0, comma);
    const std::size_t first = field.find_first_not_of(" \t");
    field = first == std::string_view::npos ? "" : field.substr(first, field.find_last_not_of(" \t") - first + 1);
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    fields.emplace_back(field);
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

/// A line of a file with the column names of its head line.
class Row {
 public:
  Row(const LineReader& reader, const std::vector<std::string>& columns, std::vector<std::string> fields)
      : reader_(reader), columns_(columns), fields_(std::move(fields)) {
    if (fields_.size() != columns_.size())
      reader.fail("{} values where the head line has {} columns ({})", fields_.size(), columns_.size(),
                  fmt::format("{}", fmt::join(columns_, ",")));
  }
  const std::string* find(std::string_view column) const {
    const auto at = std::find(columns_.begin(), columns_.end(), column);
    return at == columns_.end() ? nullptr : &fields_[static_cast<std::size_t>(at - columns_.begin())];
  }
  double number(std::string_view column) const {
    const std::string& text = *find(column);
    const std::optional<double> value = to_double(text);
    if (!value || !std::isfinite(*value)) reader_.fail("{} is '{}'; expected a number", column, text);
    return *value;
  }
  double positive(std::string_view column) const {
    const double value = number(column);
    if (!(value > 0)) reader_.fail("{} is {}; expected a number > 0", column, value);
    // Within these limits the square of a ratio of two neither overflows nor vanishes.
    constexpr double least = 1e-50, most = 1e50;
    if (!(value >= least && value <= most)) reader_.fail("{} is {}; expected a number from {:g} to {:g}", column, value, least, most);
    return value;
  }
  /// The point of the columns vertexS or xS, yS (and zS) for a suffix S.
  template <int Dim>
  Vec<Dim> point(const std::string& suffix, const std::vector<Vec<Dim>>& vertices) const {
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
    return x;
  }
  const LineReader& reader() const { return reader_; }
  std::string place() const { return fmt::format("{}, line {}", reader_.path(), reader_.number()); }

 private:
  const LineReader& reader_;
  const std::vector<std::string>& columns_;
  std::vector<std::string> fields_;
};

/// Checks the head line: every column is known, named once, and no point lacks a coordinate.
template <int Dim>
void check_columns(const LineReader& reader, const std::vector<std::string>& columns, const std::vector<std::string>& suffixes,
                   bool names_needed) {
  std::vector<std::string> known = {"name", "weight", "sd"};
  for (const std::string& suffix : suffixes) {
    known.push_back("vertex" + suffix);
    for (int k = 0; k < Dim; ++k) known.push_back(axes[static_cast<std::size_t>(k)] + suffix);
  }
  const auto has = [&](const std::string& name) { return std::find(columns.begin(), columns.end(), name) != columns.end(); };
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (std::find(known.begin(), known.end(), columns[i]) == known.end())
      reader.fail("unknown column '{}'; of a {}-dimensional shape expected a head line with some of {}", columns[i], Dim,
                  fmt::format("{}", fmt::join(known, ",")));
    if (std::find(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(i), columns[i]) !=
        columns.begin() + static_cast<std::ptrdiff_t>(i))
      reader.fail("two columns are named '{}'", columns[i]);
  }
  for (const std::string& suffix : suffixes) {
    if (has("vertex" + suffix)) continue;
    for (int k = 0; k < Dim; ++k)
      if (const std::string name = axes[static_cast<std::size_t>(k)] + suffix; !has(name))
        reader.fail("there is no column '{}'; too few columns for a point in {} dimensions, and no 'vertex{}'", name, Dim, suffix);
  }
  if (names_needed && !has("name")) reader.fail("there is no column 'name', by which points of two files belong together");
  if (has("weight") && has("sd")) reader.fail("'weight' and 'sd' exclude each other");
}

/// Calls body(row, name) for every line; names are distinct.
template <int Dim, class Body>
void for_each_row(const std::string& path, const std::vector<std::string>& suffixes, bool names_needed, Body&& body) {
  const std::string text = InputFile(path).read();
  LineReader reader(path, text);
  if (!reader.next()) throw_input_error("{}: holds no landmark; expected a head line with the names of the columns", path);
  const std::vector<std::string> columns = fields_of(reader.line());
  check_columns<Dim>(reader, columns, suffixes, names_needed);
  std::map<std::string, std::size_t> line_of;
  while (reader.next()) {
    const Row row(reader, columns, fields_of(reader.line()));
    const std::string* given = row.find("name");
    const std::string name = given ? *given : fmt::format("line {}", reader.number());
    if (name.empty()) reader.fail("the name is empty");
    if (const auto [at, is_new] = line_of.emplace(name, reader.number()); !is_new)
      reader.fail("the name '{}' stands in line {} already", name, at->second);
    body(row, name);
  }
  if (line_of.empty()) throw_input_error("{}: holds no landmark besides its head line", path);
}

/// Standard deviations become weights 1 / sd^2, scaled to a mean of 1.
template <int Dim>
void weigh_by_deviations(std::vector<Landmark<Dim>>& landmarks) {
  double sum = 0;
  for (auto& landmark : landmarks) sum += landmark.weight = 1 / (landmark.weight * landmark.weight);
  for (auto& landmark : landmarks) landmark.weight *= static_cast<double>(landmarks.size()) / sum;
}

}  // namespace

template <int Dim>
std::vector<Landmark<Dim>> read_landmarks(const LandmarkOptions& options, const std::vector<Vec<Dim>>& reference,
                                          const std::vector<Vec<Dim>>& template_shape) {
  std::vector<Landmark<Dim>> landmarks;
  if (options.file.empty()) {
    if (!options.template_file.empty())
      throw_input_error("landmarks.template_file: {}: landmarks.file, the points of the reference, is missing", options.template_file);
    return landmarks;
  }
  const bool one_file = options.template_file.empty();
  bool has_deviations = false;
  std::map<std::string, std::size_t> line_of;
  for_each_row<Dim>(options.file, one_file ? std::vector<std::string>{"1", "2"} : std::vector<std::string>{""}, !one_file,
                    [&](const Row& row, const std::string& name) {
                      Landmark<Dim> landmark{name, row.point<Dim>(one_file ? "1" : "", reference), Vec<Dim>::Zero()};
                      if (one_file) landmark.on_template = row.point<Dim>("2", template_shape);
                      has_deviations = row.find("sd") != nullptr;
                      if (has_deviations) landmark.weight = row.positive("sd");
                      if (row.find("weight")) landmark.weight = row.positive("weight");
                      line_of[name] = row.reader().number();
                      landmark.reference_origin = landmark.template_origin = row.place();
                      landmarks.push_back(std::move(landmark));
                    });
  if (!one_file) {
    struct Found {
      Vec<Dim> point;
      std::string place;
    };
    std::map<std::string, Found> there;
    for_each_row<Dim>(options.template_file, {""}, true, [&](const Row& row, const std::string& name) {
      if (!line_of.contains(name)) row.reader().fail("the name '{}' is unknown to {}", name, options.file);
      if (row.find("sd") || row.find("weight")) row.reader().fail("weights stand in {}", options.file);
      there[name] = {row.point<Dim>("", template_shape), row.place()};
    });
    for (auto& landmark : landmarks) {
      const auto at = there.find(landmark.name);
      if (at == there.end())
        throw_input_error("{}, line {}: the name '{}' is unknown to {}", options.file, line_of[landmark.name], landmark.name,
                          options.template_file);
      landmark.on_template = at->second.point;
      landmark.template_origin = at->second.place;
    }
  }
  if (has_deviations) weigh_by_deviations(landmarks);
  return landmarks;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                                     \
  template std::vector<Landmark<Dim>> read_landmarks<Dim>(const LandmarkOptions&, const std::vector<Vec<Dim>>&,         \
                                                          const std::vector<Vec<Dim>>&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
