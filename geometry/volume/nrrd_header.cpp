// NRRD: https://teem.sourceforge.net/nrrd/format.html
#include "base/error.h"
#include "base/printable.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/volume/grid_file.h"
#include "geometry/volume/header_fields.h"
#include "geometry/volume/volume_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace shellmatch {

namespace {

struct NrrdFields {
  std::vector<std::int64_t> size;
  std::vector<double> spacings, minima, maxima;
  std::string type, encoding, space, directions, origin, units, centres, kinds, data_file;
  std::map<std::int64_t, Segment> segments;  // by their numbers
  std::int64_t n_dimensions = 0;
  bool is_big_endian = false, is_ended = false;
};

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

VoxelType type_of(const LineReader& lines, const std::string& name) {
  struct Name {
    VoxelType type;
    std::initializer_list<std::string_view> names;
  };
  static const Name table[] = {
      {VoxelType::int8, {"signed char", "int8", "int8_t"}},
      {VoxelType::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {VoxelType::int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {VoxelType::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {VoxelType::int32, {"int", "signed int", "int32", "int32_t"}},
      {VoxelType::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
      {VoxelType::int64,
       {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"}},
      {VoxelType::uint64, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
      {VoxelType::float32, {"float"}},
      {VoxelType::float64, {"double"}}};
  for (const auto& [type, names] : table)
    if (std::ranges::find(names, name) != names.end()) return type;
  throw_input_error("{}: its type of values ('{}') is not supported; save it with integers or floating point numbers",
                    lines.path(), printable(name));
}

// 3D Slicer's keys, "Segment0_Name:=Femur"; other keys and values are of no concern.
void add_segment_key(std::string_view line, std::map<std::int64_t, Segment>& segments) {
  constexpr std::string_view start = "Segment";
  const std::size_t at = line.find(":="), bar = line.find('_');
  if (!line.starts_with(start) || bar == line.npos || bar > at) return;
  const auto number = to_integer(line.substr(start.size(), bar - start.size()));
  if (!number || *number < 0) return;
  const std::string_view key = line.substr(bar + 1, at - bar - 1), value = line.substr(at + 2);
  Segment& segment = segments[*number];
  if (key == "Name") segment.name = value;
  if (key == "LabelValue") segment.label = to_integer(value);
  if (key == "Layer") segment.layer = to_integer(value);
}

NrrdFields fields_of(LineReader& lines) {
  NrrdFields f;
  while (lines.next_line()) {
    std::string_view name, value;
    f.is_ended = lines.line().empty();
    if (f.is_ended) break;
    if (lines.line().starts_with('#')) continue;
    if (lines.line().find(":=") != lines.line().npos) {
      add_segment_key(lines.line(), f.segments);
      continue;
    }
    if (!split_field(lines.line(), ':', name, value))
      lines.fail("is neither a field ('name: value') nor a comment; export the volume again");
    const std::string field = lower(name);
    if (field == "dimension") {
      std::string_view rest = value;
      f.n_dimensions = lines.integer_of(rest, "the dimension");
    } else if (field == "sizes") f.size = counts_of(lines, "sizes", value);
    else if (field == "type") f.type = lower(value);
    else if (field == "encoding") f.encoding = lower(value);
    else if (field == "endian") f.is_big_endian = lower(value) == "big";
    else if (field == "space") f.space = lower(value);
    else if (field == "spacings") f.spacings = numbers_of(lines, field, value, 0);
    else if (field == "axis mins" || field == "axismins") f.minima = numbers_of(lines, field, value, 0);
    else if (field == "axis maxs" || field == "axismaxs") f.maxima = numbers_of(lines, field, value, 0);
    else if (field == "centers" || field == "centerings") f.centres = lower(value);
    else if (field == "kinds") f.kinds = lower(value);
    else if (field == "space directions") f.directions = value;
    else if (field == "space origin") f.origin = value;
    else if (field == "space units") f.units = value;
    else if (field == "data file" || field == "datafile") f.data_file = value;
    else if (field == "byte skip" || field == "byteskip" || field == "line skip" || field == "lineskip") {
      std::string_view rest = value;
      if (lines.integer_of(rest, field) != 0) lines.fail("'{}' is not supported; export the volume again", field);
    }
  }
  return f;
}

// "(1,0,0) (0,1,0) (0,0,1)": 3 n numbers.
std::vector<double> vectors_of(const LineReader& lines, std::string_view name, std::string text, std::size_t n) {
  for (char& c : text)
    if (c == '(' || c == ')' || c == ',') c = ' ';
  return numbers_of(lines, name, text, 3 * n);
}

// Where the axes have no directions. What lies between an axis' minimum and maximum are the voxels or, where it is
// centred on nodes, their centres. As Teem, ITK and VTK do, an axis that does not say is taken to be centred on cells.
void set_axes(const std::string& path, const NrrdFields& f, VoxelGrid& grid, GridFile& file) {
  std::vector<std::string_view> centres;
  for (std::string_view rest = f.centres, word = next_word(rest); !word.empty(); word = next_word(rest))
    centres.push_back(word);
  const auto check_count = [&](std::string_view name, std::size_t n) {
    if (n != 0 && n != f.size.size())
      throw_input_error("{}: {} has {} entries for {} dimensions; export the volume again", path, name, n,
                        f.size.size());
  };
  check_count("spacings", f.spacings.size());
  check_count("axis mins", f.minima.size());
  check_count("axis maxs", f.maxima.size());
  check_count("centers", centres.size());
  for (int k = 0; k < 3; ++k) {
    constexpr double unsaid = std::numeric_limits<double>::quiet_NaN();
    const auto at = [&](const std::vector<double>& numbers) { return numbers.empty() ? unsaid : numbers[k]; };
    const bool is_node = !centres.empty() && centres[k] == "node";
    const double minimum = at(f.minima), maximum = at(f.maxima);
    double spacing = at(f.spacings);
    if (std::isnan(spacing) && !std::isnan(maximum)) {
      if (std::isnan(minimum))
        throw_input_error(
            "{}: axis {} has a maximum (axis maxs), but neither a minimum nor a spacing; export the volume again", path,
            k + 1);
      spacing = (maximum - minimum) / (grid.size[k] - (is_node ? 1 : 0));
    }
    if (std::isnan(spacing)) {
      file.notes.push_back(fmt::format("its header gives no spacing along axis {}: taken to be 1", k + 1));
      spacing = 1;
    }
    if (!(spacing > 0 && std::isfinite(spacing)))
      throw_input_error("{}: the spacing of its voxels along axis {} is {:g}, and must be positive", path, k + 1,
                        spacing);
    grid.axes.col(k) = spacing * Vec<3>::Unit(k);
    if (!std::isnan(minimum)) grid.origin[k] = minimum + (is_node ? 0 : spacing / 2);
  }
}

// The format wants lengths once: in the directions, or as spacings.
void note_other_spacings(const NrrdFields& f, const VoxelGrid& grid, GridFile& file) {
  constexpr double tolerance = 1e-3;
  if (f.spacings.size() != f.size.size()) return;
  for (int k = 0; k < 3; ++k) {
    const double length = grid.axes.col(k).norm();
    if (std::isnan(f.spacings[k]) || std::abs(f.spacings[k] - length) <= tolerance * length) continue;
    file.notes.push_back(
        fmt::format("its header contradicts itself: voxels of {:g} along axis {} (spacings), and of {:g} by its space "
                    "directions, by which it is read",
                    f.spacings[k], k + 1, length));
    return;
  }
}

void set_frame(const LineReader& lines, const NrrdFields& f, VoxelGrid& grid, GridFile& file) {
  if (!f.directions.empty()) {
    const std::vector<double> v = vectors_of(lines, "space directions", f.directions, 3);
    for (int k = 0; k < 3; ++k) grid.axes.col(k) = Vec<3>(v[3 * k], v[3 * k + 1], v[3 * k + 2]);
    note_other_spacings(f, grid, file);
  } else {
    set_axes(lines.path(), f, grid, file);
  }
  if (!f.origin.empty()) {
    const std::vector<double> v = vectors_of(lines, "space origin", f.origin, 1);
    grid.origin = Vec<3>(v[0], v[1], v[2]);
  }
  // What says nothing of a patient is taken for LPS, as by ITK.
  const std::string frame = f.space == "ras" || f.space.starts_with("right-anterior-superior")  ? "ras"
                            : f.space == "las" || f.space.starts_with("left-anterior-superior") ? "las"
                                                                                                : "lps";
  file.placed_by = fmt::format("the axes of its header, in {}", frame == "ras"   ? "RAS"
                                                                : frame == "las" ? "LAS"
                                                                                 : "LPS");
  if (f.space.empty()) file.placed_by += ", as it names no space";
  else if (frame == "lps" && f.space != "lps" && !f.space.starts_with("left-posterior-superior"))
    file.placed_by += fmt::format(", as its space '{}' says nothing of a patient", printable(f.space, 30));
  if (frame == "lps") grid = exchange_space(grid);
  if (frame == "las") {
    grid.origin[0] *= -1;
    grid.axes.row(0) *= -1;
    file.space = "left-anterior-superior";
    file.notes.emplace_back(
        "its space is left-anterior-superior, where ITK up to 5.4.3, and ANTs and 3D Slicer with it, exchange left and "
        "right in place of front and back: for them it lies half a turn about z from here");
  }
}

// Of the axes: what is not one of space says "none".
std::string without_list_axis(std::string directions) {
  for (std::size_t at; (at = directions.find("none")) != directions.npos;) directions.erase(at, 4);
  return directions;
}

// A fourth axis along which layers of segments lie is no axis of space: 3D Slicer's comes first.
void take_list_axis(const std::string& path, NrrdFields& f, VolumeHeader& header) {
  if (f.size.size() == 4 && !f.directions.empty()) {
    std::vector<std::string_view> kinds;
    for (std::string_view rest = f.kinds, word = next_word(rest); !word.empty(); word = next_word(rest))
      kinds.push_back(word);
    const bool is_first = kinds.size() == 4 && kinds[0] == "list", is_last = kinds.size() == 4 && kinds[3] == "list";
    const std::int64_t n = is_last && !is_first ? f.size[3] : f.size[0];
    if ((is_first || is_last) && n > 0 && n <= most_layers) {
      header.n_layers = static_cast<int>(n);
      header.has_layers_first = is_first;
      f.size.erase(is_first ? f.size.begin() : f.size.end() - 1);
      f.directions = without_list_axis(f.directions);
    }
  }
  if (f.size.size() > 3)
    throw_input_error("{}: has {} dimensions; save one of its volumes as a file of three", path, f.size.size());
}

// Before 3D Slicer kept several segments in a layer, each had one of its own, with the value 1.
void set_segments(const NrrdFields& f, VolumeHeader& header) {
  for (const auto& [number, segment] : f.segments) {
    if (segment.name.empty()) continue;
    header.segments.push_back(segment);
    Segment& last = header.segments.back();
    if (!last.label) last.label = 1;
    if (!last.layer) last.layer = header.n_layers > 1 ? number : 0;
  }
}

// A quoted name for each axis; one for all, or none.
std::string unit_of(const std::string& units) {
  std::string unit;
  for (std::size_t begin = units.find('"'); begin != units.npos;) {
    const std::size_t end = units.find('"', begin + 1);
    if (end == units.npos) return "";
    const std::string one = printable(units.substr(begin + 1, end - begin - 1), 20);
    if (!unit.empty() && one != unit) return "";
    unit = one;
    begin = units.find('"', end + 1);
  }
  return unit;
}

}  // namespace

VolumeHeader read_nrrd_header(const std::string& path) {
  const std::string text = header_text(path, [](std::string_view line) { return line.empty(); });
  LineReader lines(path, text, 0);
  if (!lines.next_line() || !lines.line().starts_with("NRRD"))
    throw_input_error("{}: no NRRD file: it does not begin with the word NRRD; export the volume again", path);
  NrrdFields f = fields_of(lines);
  const auto does_not_end = [&] {
    throw_input_error(
        "{}: its header does not end: no blank line in the first {} bytes; copy or export the volume again", path,
        text.size());
  };
  if (!f.is_ended && text.size() >= longest_header) does_not_end();
  if (f.type.empty() || f.encoding.empty() || f.size.empty() ||
      f.n_dimensions != static_cast<std::int64_t>(f.size.size()))
    throw_input_error(
        "{}: its header does not say type, dimension, sizes and encoding, one size for each dimension; export the "
        "volume again",
        path);
  // A header whose values are in another file may end with its own.
  if (!f.is_ended && f.data_file.empty()) does_not_end();
  VolumeHeader header;
  take_list_axis(path, f, header);
  set_size(path, f.size, header.grid);
  header.type = type_of(lines, f.type);
  set_segments(f, header);
  GridFile file;
  set_frame(lines, f, header.grid, file);
  header.grid.unit = unit_of(f.units);
  if (const auto millimetres = millimetres_of(header.grid.unit)) {
    file.unit = std::exchange(header.grid.unit, "mm");
    header.grid.axes *= *millimetres;
    header.grid.origin *= *millimetres;
    if (*millimetres != 1)
      file.notes.push_back(
          fmt::format("its numbers are in {}, as it says, and turned into millimetres; ITK, ANTs and 3D Slicer leave "
                      "them as they are",
                      file.unit));
  } else if (header.grid.unit.empty() && !f.units.empty()) {
    file.notes.emplace_back("its axes name no unit, or not all the same: nothing is converted");
  }
  header.grid.file = std::make_shared<const GridFile>(std::move(file));
  header.is_big_endian = f.is_big_endian;
  header.file = f.data_file.empty() ? path : file_of_values(path, f.data_file);
  header.offset = f.data_file.empty() ? text.size() - lines.n_left() : 0;
  if (f.encoding == "gzip" || f.encoding == "gz") header.encoding = VolumeHeader::deflated;
  else if (f.encoding == "ascii" || f.encoding == "text" || f.encoding == "txt") header.encoding = VolumeHeader::text;
  else if (f.encoding != "raw")
    throw_input_error("{}: the encoding '{}' is not supported; save it as raw or gzip", path, printable(f.encoding));
  return header;
}

}  // namespace shellmatch
