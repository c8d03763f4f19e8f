#include "geometry/volume/volume_header.h"

#include "base/error.h"
#include "base/printable.h"
#include "geometry/io/input_file.h"
#include "geometry/volume/volume_file.h"
#include "geometry/volume/volume_name.h"

#include <algorithm>
#include <filesystem>

namespace shellmatch {

namespace {

// In the order of VoxelType.
constexpr ValueType value_types[] = {ValueType::uint8,   ValueType::int8,   ValueType::uint16, ValueType::int16,
                                     ValueType::uint32,  ValueType::int32,  ValueType::uint64, ValueType::int64,
                                     ValueType::float32, ValueType::float64};

}  // namespace

VolumeHeader read_volume_header(const std::string& path) {
  const InputFile file(path);
  std::error_code error;
  if (std::filesystem::file_size(path, error) == 0 && !error)
    throw_input_error("{}: the file is empty (0 bytes)", path);
  VolumeHeader header;
  switch (volume_format(path)) {
    case VolumeFormat::nrrd: header = read_nrrd_header(path); break;
    case VolumeFormat::meta_image: header = read_meta_image_header(path); break;
    case VolumeFormat::vti: header = read_vti(path, false).first; break;
    case VolumeFormat::nifti: header = read_nifti_header(path); break;
  }
  check_frame(path, header.grid);
  return header;
}

void set_size(const std::string& path, std::span<const std::int64_t> size, VoxelGrid& grid) {
  if (size.size() < 3 || *std::min_element(size.begin(), size.begin() + 3) < 2) {
    for (const std::int64_t n : size)
      if (n < 1) throw_input_error("{}: a dimension of {} voxels; export the volume again", path, n);
    throw_input_error("{}: a single slice, not a volume; an outline in the plane is read from a mask (.png, .pgm)",
                      path);
  }
  std::int64_t n_voxels = 1;
  for (int k = 0; k < 3; ++k) {
    if (size[k] > max_voxels || (n_voxels *= size[k]) > max_voxels)
      throw_input_error(
          "{}: has more than {} voxels ({} x {} x {}); cut it to the region of interest, or sample it more coarsely",
          path, max_voxels, size[0], size[1], size[2]);
    grid.size[k] = static_cast<int>(size[k]);
  }
}

void check_frame(const std::string& path, const VoxelGrid& grid) {
  const Vec<3> spacing = grid.axes.colwise().norm();
  if (!grid.origin.allFinite() || !grid.axes.allFinite() || !(spacing.minCoeff() > 0))
    throw_input_error("{}: the spacing of its voxels ({}) must be positive, and its position finite", path,
                      spacing_text(grid));
  if (!(spacing.maxCoeff() < 1e6 && spacing.minCoeff() > 1e-6 && grid.origin.cwiseAbs().maxCoeff() < 1e9))
    throw_input_error("{}: the spacing of its voxels ({}) or its position is out of all proportion", path,
                      spacing_text(grid));
  if (!(grid.voxel_volume() > 1e-3 * spacing.prod()))
    throw_input_error("{}: its axes do not span space: two of them have the same direction, or nearly", path);
}

std::string file_of_values(const std::string& path, const std::string& name) {
  if (name.find('%') != name.npos || name.starts_with("LIST") || name.find(' ') != name.npos)
    throw_input_error("{}: its values are in several files ('{}'); export the volume as one file", path,
                      printable(name));
  const std::string file = (std::filesystem::path(path).parent_path() / name).string();
  try {
    const InputFile values(file);
  } catch (const InputError& error) {
    throw_input_error("{}: the file that its header names for the values: {}", path, error.what());
  }
  return file;
}

ValueType value_type(VoxelType type) { return value_types[static_cast<std::size_t>(type)]; }

std::optional<VoxelType> voxel_type(ValueType type) {
  const auto at = std::ranges::find(value_types, type);
  return at == std::end(value_types) ? std::nullopt : std::optional(static_cast<VoxelType>(at - value_types));
}

}  // namespace shellmatch
