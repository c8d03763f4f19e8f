#pragma once
/// \file
/// The voxels of a label, cut out of their volume and rid of noise.

#include "geometry/volume/volume.h"
#include "geometry/volume/volume_name.h"

#include <string>
#include <vector>

namespace shellmatch {

/// Components of fewer voxels than a cube of three are noise of a segmentation, and so are cavities.
inline constexpr std::size_t least_component = 27;

/// The most voxels along an axis of a region; of larger labels blocks of voxels become one.
inline constexpr int most_voxels_across = 160;

/// Free voxels around the label.
inline constexpr int region_margin = 4;

struct LabelRegion {
  VoxelGrid grid;             ///< a box around the label with a margin; RAS
  std::vector<float> shares;  ///< of each voxel that belongs to the label: 0 or 1 but for blocks
  std::vector<std::string> notes;
  std::size_t n_at_border = 0;  ///< chosen voxels at the border of the volume
};

/// Components and cavities of fewer than least_component voxels go (the largest component stays); notes say so. What
/// reaches the border of the volume ends there. \param volume canonical() \param source for messages \throws InputError
/// where a label is absent, naming those that there are, or where no voxel or every voxel is chosen
LabelRegion label_region(const Volume& volume, const VoxelChoice& choice, const std::string& source);

}  // namespace shellmatch
