#pragma once
/// \file
/// Volumes whose values a program has already, instead of a file.

#include "geometry/volume/volume.h"
#include "geometry/volume/volume_name.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace shellmatch {

/// A volume that is checked as one out of a file.
/// \param source for messages
/// \param size voxels along each axis, 2 or more
/// \param to_space 4 by 4: carries the indices (i, j, k, 1) of a voxel to its centre, in `space`; the last row is 0 0 0
/// 1 \param values the first index runs fastest \throws InputError for sizes and frames that no file may have, and for
/// values that are not finite or, of a type of whole numbers,
///   larger than largest_label
Volume make_volume(const std::string& source, const std::array<std::int64_t, 3>& size, const Mat<4>& to_space,
                   Space space, VoxelType type, std::vector<float> values);

}  // namespace shellmatch
