#pragma once
/// \file
/// Where a NIfTI's voxels lie: by its sform where there is one, else its qform, else the size of its voxels alone.

#include "geometry/volume/grid_file.h"
#include "geometry/volume/volume.h"

#include <string>

namespace shellmatch {

/// Sets axes and origin, and says in `file` by what, and where other programs go by something else.
/// \throws InputError where they are not finite
void place_by_nifti(const std::string& path, const NiftiPlacement& placement, VoxelGrid& grid, GridFile& file);

}  // namespace shellmatch
