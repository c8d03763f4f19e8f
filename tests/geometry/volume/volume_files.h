#pragma once
/// \file
/// Volumes to write into files, by hand: the readers and writers under test are not asked.

#include "geometry/volume/volume.h"

#include <fmt/format.h>

#include <cstring>
#include <functional>
#include <string>

namespace shellmatch::testing {

/// A grid of n voxels of the spacing whose axes are those of RAS, `turned` ones backward, over the box that begins at
/// `low`.
inline VoxelGrid grid_over(const Vec<3>& low, const Vec<3>& spacing, const std::array<int, 3>& size,
                           const std::array<bool, 3>& turned = {}) {
  VoxelGrid grid;
  grid.size = size;
  for (int k = 0; k < 3; ++k) {
    grid.axes.col(k) = (turned[k] ? -spacing[k] : spacing[k]) * Vec<3>::Unit(k);
    grid.origin[k] = turned[k] ? low[k] + spacing[k] * (size[k] - 1) : low[k];
  }
  return grid;
}

/// The same with the axes in the order z, x, y.
inline VoxelGrid permuted(const VoxelGrid& grid) {
  VoxelGrid result = grid;
  for (int k = 0; k < 3; ++k) {
    result.axes.col(k) = grid.axes.col((k + 2) % 3);
    result.size[k] = grid.size[(k + 2) % 3];
  }
  return result;
}

/// Values by their place in RAS.
inline Volume volume_of(const VoxelGrid& grid, const std::function<double(const Vec<3>&)>& value,
                        VoxelType type = VoxelType::uint8) {
  Volume volume{grid, type, {}};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        volume.values.push_back(static_cast<float>(value(grid.position(Vec<3>(i, j, k)))));
  return volume;
}

template <class T>
void put(std::string& bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

template <class T>
std::string bytes_of(const Volume& volume) {
  std::string bytes(volume.values.size() * sizeof(T), '\0');
  for (std::size_t i = 0; i < volume.values.size(); ++i) put(bytes, i * sizeof(T), static_cast<T>(volume.values[i]));
  return bytes;
}

/// NIfTI-1 of bytes, its frame in the sform.
inline std::string nifti(const Volume& volume) {
  const VoxelGrid& grid = volume.grid;
  std::string header(352, '\0');
  put<std::int32_t>(header, 0, 348);
  put<std::int16_t>(header, 40, 3);
  for (std::size_t k = 0; k < 7; ++k)
    put<std::int16_t>(header, 42 + 2 * k, k < 3 ? static_cast<std::int16_t>(grid.size[k]) : std::int16_t{1});
  put<std::int16_t>(header, 70, 2);
  put<std::int16_t>(header, 72, 8);
  put<float>(header, 76, 1);
  for (std::size_t k = 0; k < 3; ++k)
    put<float>(header, 80 + 4 * k, static_cast<float>(grid.axes.col(static_cast<int>(k)).norm()));
  put<float>(header, 108, 352);
  put<float>(header, 112, 1);
  put<std::int16_t>(header, 254, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      put<float>(header, 280 + 16 * i + 4 * j, static_cast<float>(grid.axes(static_cast<int>(i), static_cast<int>(j))));
    put<float>(header, 292 + 16 * i, static_cast<float>(grid.origin[static_cast<int>(i)]));
  }
  header.replace(344, 3, "n+1");
  return header + bytes_of<std::uint8_t>(volume);
}

/// NRRD of bytes in either frame.
inline std::string nrrd(const Volume& volume, bool lps) {
  const VoxelGrid grid = lps ? exchange_space(volume.grid) : volume.grid;
  const auto text = [](const Vec<3>& x) { return fmt::format("({},{},{})", x[0], x[1], x[2]); };
  return fmt::format(
             "NRRD0004\ntype: unsigned char\ndimension: 3\nspace: {}\nsizes: {} {} {}\nspace directions: {} {} "
             "{}\nkinds: domain domain domain\n"
             "encoding: raw\nspace origin: {}\n\n",
             lps ? "left-posterior-superior" : "right-anterior-superior", grid.size[0], grid.size[1], grid.size[2],
             text(grid.axes.col(0)), text(grid.axes.col(1)), text(grid.axes.col(2)), text(grid.origin)) +
         bytes_of<std::uint8_t>(volume);
}

/// MetaImage of bytes, which is in LPS. \pre the axes are those of the coordinates
inline std::string meta_image(const Volume& volume) {
  const VoxelGrid grid = exchange_space(volume.grid);
  const auto sign = [&](int k) { return grid.axes(k, k) < 0 ? -1 : 1; };
  return fmt::format(
             "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = "
             "False\nTransformMatrix = {} 0 0 0 {} 0 0 0 {}\n"
             "Offset = {} {} {}\nCenterOfRotation = 0 0 0\nElementSpacing = {} {} {}\nDimSize = {} {} {}\nElementType "
             "= MET_UCHAR\nElementDataFile = LOCAL\n",
             sign(0), sign(1), sign(2), grid.origin[0], grid.origin[1], grid.origin[2], std::abs(grid.axes(0, 0)),
             std::abs(grid.axes(1, 1)), std::abs(grid.axes(2, 2)), grid.size[0], grid.size[1], grid.size[2]) +
         bytes_of<std::uint8_t>(volume);
}

}  // namespace shellmatch::testing
