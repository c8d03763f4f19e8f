#include "matching/pairs/landmark_file.h"

#include "base/error.h"
#include "base/text.h"
#include "geometry/io/input_file.h"
#include "geometry/io/read_text.h"
#include "matching/pairs/slicer_points.h"

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
  for (const std::string_view field : csv_fields(line)) fields.push_back(csv_text(field));
  return fields;
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
  /// Coordinates are converted from one frame to the other.
  template <int Dim>
  Vec<Dim> point(const std::string& suffix, const std::vector<Vec<Dim>>& vertices, Space from, Space to) const {
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
  std::vector<std::string> columns = fields_of(reader.line());
  for (std::string& column : columns)
    for (const std::string_view known : {"name", "label"})
      if (equals_ignoring_case(column, known)) column = "name";
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

std::vector<NamedPoint<3>> slicer_landmarks(const std::string& path, Space shapes, std::vector<std::string>& notes) {
  const SlicerPoints file = read_slicer_points(path);
  std::vector<NamedPoint<3>> points;
  std::map<std::string, std::string> place_of;
  for (const SlicerPoint& point : file.points) {
    if (!point.has_position) continue;
    if (point.name.empty()) throw_input_error("{}: the label is empty, by which points of two files belong together", point.place);
    if (const auto [at, is_new] = place_of.emplace(point.name, point.place); !is_new)
      throw_input_error("{}: the name '{}' stands in {} already", point.place, point.name, at->second);
    points.push_back({point.name, in_space(point.position, point.space, or_default(shapes)), point.place});
  }
  if (points.empty()) throw_input_error("{}: none of its control points has a position", path);
  if (points.size() < file.points.size())
    notes.push_back(fmt::format("{}: {} without position left out", path, counted(file.points.size() - points.size(), "point", "points")));
  if (std::string note = space_note(file, or_default(shapes)); !note.empty()) notes.push_back(std::move(note));
  return points;
}

}  // namespace

template <int Dim>
std::vector<NamedPoint<Dim>> read_named_points(const std::string& path, const std::vector<Vec<Dim>>& vertices, Space file_space,
                                               Space shapes, std::vector<std::string>& notes) {
  if (is_slicer_file(path)) {
    if constexpr (Dim == 3) return slicer_landmarks(path, shapes, notes);
    else throw_input_error("{}: holds points of space, but the shapes are of the plane; give a CSV file", path);
  }
  std::vector<NamedPoint<Dim>> points;
  for_each_row<Dim>(path, {""}, true, [&](const Row& row, const std::string& name) {
    NamedPoint<Dim> point{name, row.point<Dim>("", vertices, file_space, shapes), row.place()};
    if (row.find("sd")) point.deviation = row.positive("sd");
    if (row.find("weight")) point.weight = row.positive("weight");
    points.push_back(std::move(point));
  });
  return points;
}

namespace {

/// Landmarks, and their standard deviations where the file has these instead of weights.
template <int Dim>
struct FileLandmarks {
  std::vector<Landmark<Dim>> landmarks;
  std::map<std::string, double> deviations = {};  ///< by name: of all, or of none
};

/// The landmarks of a file that holds the points of both shapes.
template <int Dim>
FileLandmarks<Dim> landmarks_of_both(const std::string& path, const std::vector<Vec<Dim>>& reference,
                                     const std::vector<Vec<Dim>>& template_shape, const LandmarkSpaces& spaces) {
  if (is_slicer_file(path))
    throw_input_error("{}: holds points of one shape; give those of the template, too (--template-landmarks)", path);
  FileLandmarks<Dim> read;
  for_each_row<Dim>(path, {"1", "2"}, false, [&](const Row& row, const std::string& name) {
    Landmark<Dim> landmark{name, row.point<Dim>("1", reference, spaces.reference_file, spaces.shapes),
                          row.point<Dim>("2", template_shape, spaces.shapes, spaces.shapes)};
    if (row.find("sd")) read.deviations[name] = row.positive("sd");
    if (row.find("weight")) landmark.weight = row.positive("weight");
    landmark.reference_origin = landmark.template_origin = row.place();
    read.landmarks.push_back(std::move(landmark));
  });
  return read;
}

/// The landmarks of two files, which belong together by name.
template <int Dim>
FileLandmarks<Dim> landmarks_of_each(const LandmarkOptions& options, const std::vector<Vec<Dim>>& reference,
                                     const std::vector<Vec<Dim>>& template_shape, const LandmarkSpaces& spaces, std::vector<std::string>& notes) {
  std::map<std::string, Landmark<Dim>*> landmark_of;
  const std::vector<NamedPoint<Dim>> here = read_named_points<Dim>(options.file, reference, spaces.reference_file, spaces.shapes, notes);
  FileLandmarks<Dim> read;
  std::vector<Landmark<Dim>>& landmarks = read.landmarks;
  landmarks.reserve(here.size());  // the map keeps addresses
  for (const NamedPoint<Dim>& point : here) {
    if (point.deviation) read.deviations[point.name] = *point.deviation;
    landmarks.push_back({point.name, point.point, {}, point.weight.value_or(1), point.place, {}});
    landmark_of[point.name] = &landmarks.back();
  }
  for (const NamedPoint<Dim>& point : read_named_points<Dim>(options.template_file, template_shape, spaces.shapes, spaces.shapes, notes)) {
    const auto at = landmark_of.find(point.name);
    if (at == landmark_of.end()) {
      if (options.unpaired == UnpairedLandmarks::are_left_out) continue;
      throw_input_error("{}: the name '{}' is unknown to {}", point.place, point.name, options.file);
    }
    if (point.weight || point.deviation) throw_input_error("{}: weights stand in {}", point.place, options.file);
    at->second->on_template = point.point;
    at->second->template_origin = point.place;
  }
  const auto is_unpaired = [](const Landmark<Dim>& landmark) { return landmark.template_origin.empty(); };
  if (options.unpaired == UnpairedLandmarks::are_left_out) std::erase_if(landmarks, is_unpaired);
  for (const Landmark<Dim>& landmark : landmarks)
    if (is_unpaired(landmark))
      throw_input_error("{}: the name '{}' is unknown to {}", landmark.reference_origin, landmark.name, options.template_file);
  if (landmarks.empty())
    throw_input_error("{}: has no name in common with {}; leave the landmarks out, or name them alike", options.template_file, options.file);
  return read;
}

/// Standard deviations become weights 1 / sd^2, scaled to a mean of 1.
template <int Dim>
std::vector<Landmark<Dim>> weighted(FileLandmarks<Dim> read) {
  if (read.deviations.empty()) return std::move(read.landmarks);
  double sum = 0;
  for (Landmark<Dim>& landmark : read.landmarks) {
    const double deviation = read.deviations.at(landmark.name);
    sum += landmark.weight = 1 / (deviation * deviation);
  }
  for (Landmark<Dim>& landmark : read.landmarks) landmark.weight *= static_cast<double>(read.landmarks.size()) / sum;
  return std::move(read.landmarks);
}

}  // namespace

template <int Dim>
std::vector<Landmark<Dim>> read_landmarks(const LandmarkOptions& options, const std::vector<Vec<Dim>>& reference,
                                          const std::vector<Vec<Dim>>& template_shape, const LandmarkSpaces& spaces,
                                          std::vector<std::string>* notes) {
  if (options.file.empty()) {
    if (!options.template_file.empty())
      throw_input_error("landmarks.template_file: {}: landmarks.file, the points of the reference, is missing", options.template_file);
    return {};
  }
  std::vector<std::string> own_notes;
  return weighted(options.template_file.empty()
                      ? landmarks_of_both<Dim>(options.file, reference, template_shape, spaces)
                      : landmarks_of_each<Dim>(options, reference, template_shape, spaces, notes ? *notes : own_notes));
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                                     \
  template std::vector<Landmark<Dim>> read_landmarks<Dim>(const LandmarkOptions&, const std::vector<Vec<Dim>>&,         \
                                                          const std::vector<Vec<Dim>>&, const LandmarkSpaces&, std::vector<std::string>*); \
  template std::vector<NamedPoint<Dim>> read_named_points<Dim>(const std::string&, const std::vector<Vec<Dim>>&, Space, Space, \
                                                               std::vector<std::string>&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
