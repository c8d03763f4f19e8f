#pragma once
/// \file
/// Volumes: values on a regular lattice of voxels that lies anywhere in space.
///
/// A volume is in the coordinates of its patient. Files say where their voxels are in one of two frames, whose first
/// two axes are opposite: RAS (x to the right, y to the front, z upward: NIfTI) and LPS (left, back, upward: DICOM,
/// ITK, NRRD, MetaImage).

#include "base/types.h"
#include "geometry/picture/label_choice.h"
#include "geometry/surface/space.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// From RAS to LPS and back: half a turn about the third axis.
inline Vec<3> exchange_space(const Vec<3>& x) { return in_space(x, Space::ras, Space::lps); }

struct GridFile;

/// Where the voxels are. The voxel with the index (i, j, k) has its centre at origin + axes (i, j, k).
struct VoxelGrid {
  std::array<int, 3> size{0, 0, 0};
  Vec<3> origin = Vec<3>::Zero();    ///< centre of the first voxel; in the unit of the file, millimetres as a rule
  Mat<3> axes = Mat<3>::Identity();  ///< column k leads from a voxel to the next one along axis k
  std::string unit = {};             ///< of these coordinates, where the file names it: "mm"
  std::shared_ptr<const GridFile> file =
      {};  ///< what else its file says, to be written again (geometry/volume/grid_file.h)

  std::size_t n_voxels() const { return static_cast<std::size_t>(size[0]) * size[1] * size[2]; }
  /// The linear number of a voxel: the first index runs fastest.
  std::size_t number(int i, int j, int k) const { return (static_cast<std::size_t>(k) * size[1] + j) * size[0] + i; }
  Vec<3> position(const Vec<3>& index) const { return origin + axes * index; }
  double voxel_volume() const;
  /// The smallest distance of neighbouring planes of voxels.
  double least_spacing() const;
};

/// The same voxels, given in the other frame.
VoxelGrid exchange_space(VoxelGrid grid);

/// The millimetres of a unit of length, 10 of "cm"; none where the name is not known, or there is none.
std::optional<double> millimetres_of(std::string_view unit);

/// The type of a file's values.
enum class VoxelType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

bool is_integer(VoxelType type);

/// \invariant values has grid.n_voxels() finite entries
struct Volume {
  VoxelGrid grid;
  VoxelType type = VoxelType::uint8;
  std::vector<float> values;
};

/// The same volume with its axes in another order, and turned, so that each points along the coordinate axis that is
/// closest to it: however a file orders its voxels, the result is the same to the bit.
Volume canonical(Volume volume);

/// "1 x 1 x 2.5"
std::string spacing_text(const VoxelGrid& grid);

}  // namespace shellmatch
