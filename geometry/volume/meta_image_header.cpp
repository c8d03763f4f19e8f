// MetaImage: https://itk.org/Wiki/ITK/MetaIO/Documentation
#include "base/error.h"
#include "base/printable.h"
#include "geometry/volume/grid_file.h"
#include "geometry/volume/header_fields.h"
#include "geometry/volume/volume_header.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace shellmatch {

namespace {

VoxelType type_of(const std::string& path, std::string_view name) {
  static constexpr std::pair<std::string_view, VoxelType> table[] = {
      {"MET_CHAR", VoxelType::int8},         {"MET_UCHAR", VoxelType::uint8},   {"MET_SHORT", VoxelType::int16},
      {"MET_USHORT", VoxelType::uint16},     {"MET_INT", VoxelType::int32},     {"MET_UINT", VoxelType::uint32},
      {"MET_LONG", VoxelType::int32},        {"MET_ULONG", VoxelType::uint32},  {"MET_LONG_LONG", VoxelType::int64},
      {"MET_ULONG_LONG", VoxelType::uint64}, {"MET_FLOAT", VoxelType::float32}, {"MET_DOUBLE", VoxelType::float64}};
  for (const auto& [text, type] : table)
    if (text == name) return type;
  throw_input_error("{}: its type of values ('{}') is not supported; save it with integers or floating point numbers",
                    path, printable(name));
}

}  // namespace

VolumeHeader read_meta_image_header(const std::string& path) {
  const std::string text = header_text(path, [](std::string_view line) {
    std::string_view name, value;
    return split_field(line, '=', name, value) && equals_ignoring_case(name, "elementdatafile");
  });
  LineReader lines(path, text, 0);
  VolumeHeader header;
  VoxelGrid& grid = header.grid;
  std::vector<std::int64_t> size;
  std::vector<double> spacing;
  std::optional<VoxelType> type;
  std::optional<std::string> data_file;
  std::int64_t header_size = 0;
  while (!data_file && lines.next_line()) {
    std::string_view name, value;
    if (lines.line().empty() || !split_field(lines.line(), '=', name, value)) continue;
    const auto is = [&](std::string_view field) { return equals_ignoring_case(name, field); };
    const auto three = [&] { return numbers_of(lines, name, value, 3); };
    const bool is_true = equals_ignoring_case(value, "true") || value == "1";
    if (is("ndims") && value != "3")
      throw_input_error("{}: has {} dimensions; a volume has three: save one as a file of its own", path,
                        printable(value, 20));
    else if (is("dimsize")) size = counts_of(lines, name, value);
    else if (is("elementspacing")) spacing = three();
    else if (is("elementsize") && spacing.empty()) spacing = three();
    else if (is("offset") || is("position") || is("origin")) {
      const std::vector<double> v = three();
      grid.origin = Vec<3>(v[0], v[1], v[2]);
    } else if (is("transformmatrix") || is("rotation") || is("orientation")) {
      const std::vector<double> v = numbers_of(lines, name, value, 9);
      for (int k = 0; k < 3; ++k) grid.axes.col(k) = Vec<3>(v[3 * k], v[3 * k + 1], v[3 * k + 2]);
    } else if (is("binarydata") && !is_true) lines.fail("its values are written as text; save it with binary values");
    else if (is("binarydatabyteordermsb") || is("elementbyteordermsb")) header.is_big_endian = is_true;
    else if (is("compresseddata")) header.encoding = is_true ? VolumeHeader::deflated : VolumeHeader::raw;
    else if (is("headersize")) {
      std::string_view rest = value;
      header_size = lines.integer_of(rest, name);
      if (header_size < 0) lines.fail("a negative HeaderSize is not supported; export the volume again");
    } else if (is("elementnumberofchannels") && value != "1")
      throw_input_error("{}: has {} numbers for each voxel; a volume with one is wanted", path, printable(value, 20));
    else if (is("elementtype")) type = type_of(path, value);
    else if (is("elementdatafile")) data_file = value;
  }
  if (!data_file || size.empty() || !type)
    throw_input_error(
        "{}: no MetaImage that can be read: its header does not say DimSize, ElementType and ElementDataFile; export "
        "the volume again",
        path);
  set_size(path, size, grid);
  if (!spacing.empty()) grid.axes = grid.axes * Vec<3>(spacing[0], spacing[1], spacing[2]).asDiagonal();
  if (std::ranges::any_of(spacing, [](double s) { return !(s > 0); }))
    throw_input_error("{}: the spacing of its voxels must be positive", path);
  grid = exchange_space(grid);
  grid.file = std::make_shared<const GridFile>(GridFile{"its offset and matrix, in LPS", {}, {}, {}, {}});
  header.type = *type;
  const bool is_here = equals_ignoring_case(*data_file, "local");
  header.file = is_here ? path : file_of_values(path, *data_file);
  header.offset = is_here ? text.size() - lines.n_left() : static_cast<std::uintmax_t>(header_size);
  return header;
}

}  // namespace shellmatch
