#include "base/error.h"
#include "geometry/io/input_file.h"
#include "geometry/volume/volume_file.h"
#include "geometry/volume/volume_name.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>
#include <vector>

namespace shellmatch {

namespace {

template <class T>
void append_as(float value, std::vector<char>& bytes) {
  T number;
  if constexpr (std::is_integral_v<T>) {
    // Values are at most 2^24 in size, which every wider type holds.
    const double least = std::max<double>(std::numeric_limits<T>::min(), -largest_label), most = std::min<double>(std::numeric_limits<T>::max(), largest_label);
    number = static_cast<T>(std::clamp(std::round(static_cast<double>(value)), least, most));
  } else {
    number = static_cast<T>(value);
  }
  const char* const first = reinterpret_cast<const char*>(&number);
  bytes.insert(bytes.end(), first, first + sizeof number);
}

std::vector<char> bytes_of(const Volume& volume) {
  std::vector<char> bytes;
  for (const float value : volume.values) {
    switch (volume.type) {
      case VoxelType::uint8: append_as<std::uint8_t>(value, bytes); break;
      case VoxelType::int8: append_as<std::int8_t>(value, bytes); break;
      case VoxelType::uint16: append_as<std::uint16_t>(value, bytes); break;
      case VoxelType::int16: append_as<std::int16_t>(value, bytes); break;
      case VoxelType::uint32: append_as<std::uint32_t>(value, bytes); break;
      case VoxelType::int32: append_as<std::int32_t>(value, bytes); break;
      case VoxelType::uint64: append_as<std::uint64_t>(value, bytes); break;
      case VoxelType::int64: append_as<std::int64_t>(value, bytes); break;
      case VoxelType::float32: append_as<float>(value, bytes); break;
      case VoxelType::float64: append_as<double>(value, bytes); break;
    }
  }
  return bytes;
}

std::string ending_of(const std::string& path) {
  const std::string extension = file_extension(path);
  return extension == ".gz" ? ".nii.gz" : extension;
}

void write(const std::string& path, const VoxelGrid& grid_in_ras, VoxelType type, unsigned n_components, const void* values, Existing existing) {
  check_volume_output(path);
  const VoxelGrid grid = exchange_space(grid_in_ras);
  RawHeader header;
  header.type = type;
  header.n_components = n_components;
  for (int k = 0; k < 3; ++k) {
    header.size[k] = static_cast<std::uint64_t>(grid.size[k]);
    header.origin[k] = grid.origin[k];
    for (int j = 0; j < 3; ++j) header.axes[k][j] = grid.axes(j, k);
  }
  publish_file(path, existing, [&](const std::string& name) {
    // The library goes by the ending, of which a partial file has the last part only.
    const std::string own = name + "_" + ending_of(path);
    std::string complaint = write_raw_volume(own, header, values);
    std::error_code error;
    if (complaint.empty()) {
      std::filesystem::rename(own, name, error);
      if (error) complaint = error.message();
    }
    if (complaint.empty()) return;
    std::filesystem::remove(own, error);
    throw_environment_error("{}: cannot be written ({}); is the disk full or the folder read-only?", path, complaint);
  });
}

}  // namespace

void check_volume_output(const std::string& path) {
  const std::string ending = file_extension(path);
  if (!is_volume_file(path) || ending == ".nhdr" || ending == ".mhd")
    throw_input_error("{}: volumes are written as .nii, .nii.gz, .nrrd or .mha", path);
}

void write_volume(const std::string& path, const Volume& volume, Existing existing) {
  SHELLMATCH_CHECK(volume.values.size() == volume.grid.n_voxels(), "every voxel has a value");
  write(path, volume.grid, volume.type, 1, bytes_of(volume).data(), existing);
}

void write_vector_volume(const std::string& path, const VoxelGrid& grid, std::span<const float> values, Existing existing) {
  SHELLMATCH_CHECK(values.size() == 3 * grid.n_voxels(), "every voxel has three components");
  write(path, grid, VoxelType::float32, 3, values.data(), existing);
}

}  // namespace shellmatch
