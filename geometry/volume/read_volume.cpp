#include "base/error.h"
#include "geometry/volume/volume_file.h"
#include "geometry/volume/volume_header.h"
#include "geometry/volume/volume_name.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

namespace shellmatch {

namespace {

// The library is in LPS, whatever the file says.
VoxelGrid grid_of(const RawHeader& header, const std::string& path) {
  if (header.n_dimensions < 3 || *std::min_element(header.size.begin(), header.size.end()) < 2)
    throw_input_error("{}: a single slice, not a volume; an outline in the plane is read from a mask (.png, .pgm)", path);
  if (header.is_series) throw_input_error("{}: has {} dimensions; save one of its volumes as a file of three", path, header.n_dimensions);
  if (header.n_components != 1) throw_input_error("{}: has {} numbers for each voxel; a volume with one is wanted", path, header.n_components);
  VoxelGrid grid;
  std::uint64_t n_voxels = 1;
  for (int k = 0; k < 3; ++k) {
    if (header.size[k] > max_voxels || (n_voxels *= header.size[k]) > max_voxels)
      throw_input_error("{}: has more than {} voxels ({} x {} x {}); cut it to the region of interest, or sample it more coarsely", path, max_voxels,
                        header.size[0], header.size[1], header.size[2]);
    grid.size[k] = static_cast<int>(header.size[k]);
    grid.origin[k] = header.origin[k];
    for (int j = 0; j < 3; ++j) grid.axes(j, k) = header.axes[k][j];
  }
  const Vec<3> spacing = grid.axes.colwise().norm();
  if (!grid.origin.allFinite() || !grid.axes.allFinite() || !(spacing.minCoeff() > 0))
    throw_input_error("{}: the spacing of its voxels ({}) must be positive, and its position finite", path, spacing_text(grid));
  if (!(grid.voxel_volume() > 1e-3 * spacing.prod()))
    throw_input_error("{}: its axes do not span space: two of them have the same direction, or nearly", path);
  if (!(spacing.maxCoeff() < 1e6 && spacing.minCoeff() > 1e-6 && grid.origin.cwiseAbs().maxCoeff() < 1e9))
    throw_input_error("{}: the spacing of its voxels ({}) or its position is out of all proportion", path, spacing_text(grid));
  return exchange_space(grid);
}

template <class T>
void append_values(const char* bytes, const std::string& path, Volume& volume) {
  const std::size_t n = volume.grid.n_voxels();
  volume.values.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    T value;
    std::memcpy(&value, bytes + i * sizeof(T), sizeof(T));
    const auto number = static_cast<double>(value);
    if (!std::isfinite(number) || std::abs(number) > 1e30)
      throw_input_error("{}: voxel {} {} {} (counted from 0) is {}, no number that can be used; replace such voxels, by the background say", path,
                        i % volume.grid.size[0], i / volume.grid.size[0] % volume.grid.size[1], i / volume.grid.size[0] / volume.grid.size[1], number);
    if (std::is_integral_v<T> && std::abs(number) > largest_label)
      throw_input_error("{}: voxel {} (counted from 0) is {:.0f}; whole numbers up to {:.0f} can be told apart", path, i, number, largest_label);
    volume.values.push_back(static_cast<float>(number));
  }
}

void append_values(const char* bytes, const std::string& path, Volume& volume) {
  switch (volume.type) {
    case VoxelType::uint8: return append_values<std::uint8_t>(bytes, path, volume);
    case VoxelType::int8: return append_values<std::int8_t>(bytes, path, volume);
    case VoxelType::uint16: return append_values<std::uint16_t>(bytes, path, volume);
    case VoxelType::int16: return append_values<std::int16_t>(bytes, path, volume);
    case VoxelType::uint32: return append_values<std::uint32_t>(bytes, path, volume);
    case VoxelType::int32: return append_values<std::int32_t>(bytes, path, volume);
    case VoxelType::uint64: return append_values<std::uint64_t>(bytes, path, volume);
    case VoxelType::int64: return append_values<std::int64_t>(bytes, path, volume);
    case VoxelType::float32: return append_values<float>(bytes, path, volume);
    case VoxelType::float64: return append_values<double>(bytes, path, volume);
  }
}

Volume read(const std::string& path, bool with_values) {
  const VolumeData data = check_volume_header(path);
  const RawVolumeReader reader(path);
  const RawHeader& header = reader.header();
  Volume volume{grid_of(header, path), {}, {}};
  if (!header.type) throw_input_error("{}: its type of values is not supported; save it with integers or floating point numbers", path);
  volume.type = *header.type;
  const std::size_t n_bytes = volume.grid.n_voxels() * header.value_bytes;
  const std::size_t n_in_file = data.voxel_bytes > 0 ? volume.grid.n_voxels() * data.voxel_bytes : n_bytes;
  // The library takes what is missing for zeros, but for NRRD.
  if (n_in_file > most_value_bytes(data) || (with_values && volume_format(path) != VolumeFormat::nrrd && !has_values(data, n_in_file)))
    throw_input_error("{}: cut off: {} x {} x {} voxels take {} bytes, which the file, of {} bytes, does not hold", path, volume.grid.size[0],
                      volume.grid.size[1], volume.grid.size[2], n_in_file, data.file_bytes);
  if (!with_values) return volume;
  // Not set to zero: a file that is cut off takes no more memory than it has values.
  const std::unique_ptr<char[]> bytes(new char[n_bytes]);
  reader.read(bytes.get());
  append_values(bytes.get(), path, volume);
  return volume;
}

}  // namespace

VoxelGrid read_voxel_grid(const std::string& path) { return read(path, false).grid; }

Volume read_volume(const std::string& path) { return read(path, true); }

}  // namespace shellmatch
