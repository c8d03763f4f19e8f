// NRRD: https://teem.sourceforge.net/nrrd/format.html
#include "base/error.h"
#include "base/printable.h"
#include "geometry/volume/header_fields.h"
#include "geometry/volume/volume_header.h"
#include "geometry/volume/zlib_volume.h"

#include <algorithm>
#include <cctype>

namespace shellmatch {

namespace {

struct NrrdFields {
  std::vector<std::int64_t> size;
  std::vector<double> spacings, minima;
  std::string type, encoding, space, directions, origin, units, data_file;
  std::int64_t n_dimensions = 0;
  bool is_big_endian = false;
};

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

VoxelType type_of(const LineReader& lines, const std::string& name) {
  struct Name {
    VoxelType type;
    std::initializer_list<std::string_view> names;
  };
  static const Name table[] = {{VoxelType::int8, {"signed char", "int8", "int8_t"}},
                               {VoxelType::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
                               {VoxelType::int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
                               {VoxelType::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
                               {VoxelType::int32, {"int", "signed int", "int32", "int32_t"}},
                               {VoxelType::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
                               {VoxelType::int64, {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"}},
                               {VoxelType::uint64, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
                               {VoxelType::float32, {"float"}},
                               {VoxelType::float64, {"double"}}};
  for (const auto& [type, names] : table)
    if (std::ranges::find(names, name) != names.end()) return type;
  throw_input_error("{}: its type of values ('{}') is not supported; save it with integers or floating point numbers", lines.path(), printable(name));
}

NrrdFields fields_of(LineReader& lines) {
  NrrdFields f;
  while (lines.next_line() && !lines.line().empty()) {
    std::string_view name, value;
    if (lines.line().starts_with('#') || lines.line().find(":=") != lines.line().npos) continue;
    if (!split_field(lines.line(), ':', name, value)) lines.fail("is neither a field ('name: value') nor a comment; export the volume again");
    const std::string field = lower(name);
    if (field == "dimension") {
      std::string_view rest = value;
      f.n_dimensions = lines.integer_of(rest, "the dimension");
    } else if (field == "sizes") f.size = counts_of(lines, "sizes", value);
    else if (field == "type") f.type = lower(value);
    else if (field == "encoding") f.encoding = lower(value);
    else if (field == "endian") f.is_big_endian = lower(value) == "big";
    else if (field == "space") f.space = lower(value);
    else if (field == "spacings") f.spacings = numbers_of(lines, "spacings", value, f.size.size());
    else if (field == "axis mins" || field == "axismins") f.minima = numbers_of(lines, "axis mins", value, f.size.size());
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

void set_frame(const LineReader& lines, const NrrdFields& f, VoxelGrid& grid) {
  if (!f.directions.empty()) {
    const std::vector<double> v = vectors_of(lines, "space directions", f.directions, 3);
    for (int k = 0; k < 3; ++k) grid.axes.col(k) = Vec<3>(v[3 * k], v[3 * k + 1], v[3 * k + 2]);
  } else {
    for (int k = 0; k < 3; ++k) {
      const double spacing = f.spacings.empty() || std::isnan(f.spacings[k]) ? 1 : f.spacings[k];
      grid.axes.col(k) = spacing * Vec<3>::Unit(k);
      if (!f.minima.empty() && !std::isnan(f.minima[k])) grid.origin[k] = f.minima[k];
    }
  }
  if (!f.origin.empty()) {
    const std::vector<double> v = vectors_of(lines, "space origin", f.origin, 1);
    grid.origin = Vec<3>(v[0], v[1], v[2]);
  }
  // What says nothing of a patient is taken for LPS, as by ITK.
  const std::string frame = f.space == "ras" || f.space.starts_with("right-anterior-superior") ? "ras"
                            : f.space == "las" || f.space.starts_with("left-anterior-superior") ? "las" : "lps";
  if (frame == "lps") grid = exchange_space(grid);
  if (frame == "las") {
    grid.origin[0] *= -1;
    grid.axes.row(0) *= -1;
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
  std::string text;
  for_each_piece(path, 0, false, 0, longest_header, [&](std::string_view piece) { text += piece; });
  LineReader lines(path, text, 0);
  if (!lines.next_line() || !lines.line().starts_with("NRRD"))
    throw_input_error("{}: no NRRD file: it does not begin with the word NRRD; export the volume again", path);
  const NrrdFields f = fields_of(lines);
  if (f.type.empty() || f.encoding.empty() || f.size.empty() || f.n_dimensions != static_cast<std::int64_t>(f.size.size()))
    throw_input_error("{}: its header does not say type, dimension, sizes and encoding, one size for each dimension; export the volume again", path);
  if (f.size.size() > 3) throw_input_error("{}: has {} dimensions; save one of its volumes as a file of three", path, f.size.size());
  VolumeHeader header;
  set_size(path, f.size, header.grid);
  header.type = type_of(lines, f.type);
  set_frame(lines, f, header.grid);
  header.unit = unit_of(f.units);
  header.is_big_endian = f.is_big_endian;
  header.file = f.data_file.empty() ? path : file_of_values(path, f.data_file);
  header.offset = f.data_file.empty() ? text.size() - lines.n_left() : 0;
  if (f.encoding == "gzip" || f.encoding == "gz") header.encoding = VolumeHeader::deflated;
  else if (f.encoding == "ascii" || f.encoding == "text" || f.encoding == "txt") header.encoding = VolumeHeader::text;
  else if (f.encoding != "raw") throw_input_error("{}: the encoding '{}' is not supported; save it as raw or gzip", path, printable(f.encoding));
  return header;
}

}  // namespace shellmatch
