#pragma once
/// \file
/// Headers of volumes' files, checked.
///
/// ITK's readers are not used: they take missing values for zeros (NIfTI, MetaImage), and on damaged input leak memory
/// and print on the terminal. Tests compare ours with them.

#include "geometry/bytes/value_type.h"
#include "geometry/volume/volume.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// A part of a segmentation by its name, as 3D Slicer writes it into an NRRD.
struct Segment {
  std::string name;
  std::optional<std::int64_t> label, layer;  ///< both known where a header has been read
};

/// Layers of segments that may overlap, along an axis of their own.
inline constexpr int most_layers = 256;

struct VolumeHeader {
  VoxelGrid grid;  ///< RAS
  VoxelType type = VoxelType::uint8;
  double slope = 1, intercept = 0;  ///< of a value in the file

  std::string file;  ///< of the values
  std::uintmax_t offset =
      0;  ///< of the first: in the file, or in what a file that is compressed as a whole inflates to
  enum { raw, deflated, whole_file_deflated, text } encoding = raw;
  bool is_big_endian = false;

  std::vector<Segment> segments;
  int n_layers = 1;              ///< numbers for each voxel
  bool has_layers_first = true;  ///< those of a voxel follow each other, else the layers do
};

/// \throws InputError as read_voxel_grid (geometry/volume/volume_file.h)
VolumeHeader read_volume_header(const std::string& path);

VolumeHeader read_nifti_header(const std::string& path);
VolumeHeader read_nrrd_header(const std::string& path);
VolumeHeader read_meta_image_header(const std::string& path);
/// With its values, in the order of the voxels, where they are asked for. VTK's files name no frame: taken to be RAS.
std::pair<VolumeHeader, std::vector<double>> read_vti(const std::string& path, bool with_values);

/// Sets the size of the grid. \throws InputError unless there are three dimensions of 2 or more voxels, and max_voxels
/// at most
void set_size(const std::string& path, std::span<const std::int64_t> size, VoxelGrid& grid);

/// \throws InputError unless position and spacing are finite, positive and in proportion, and the axes span space
void check_frame(const std::string& path, const VoxelGrid& grid);

/// The header's word for the file of its values, as a path. \throws InputError unless that is one file
std::string file_of_values(const std::string& path, const std::string& name);

/// A voxel in a file: the type of its bytes, how many they are, and the other way round.
ValueType value_type(VoxelType type);
inline std::size_t bytes_of(VoxelType type) { return bytes_of(value_type(type)); }
std::optional<VoxelType> voxel_type(ValueType type);

}  // namespace shellmatch
