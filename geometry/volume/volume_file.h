#pragma once
/// \file
/// Files of volumes: NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd) and VTK's images (.vti).
/// Spacing, origin and direction of the axes are kept.
///
/// The files are distrusted: sizes are compared with the bytes that are there before anything is allocated.

#include "base/replace_file.h"
#include "geometry/volume/volume.h"
#include "geometry/volume/volume_name.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace shellmatch {

/// Largest number of voxels that is read, 512 x 512 x 1024, for which the reader takes 1 GB.
inline constexpr std::int64_t max_voxels = std::int64_t{1} << 28;

/// In RAS, whichever the file's frame is. \throws InputError where the file is missing, damaged or cut off, has not
/// three dimensions or one number for each voxel, or where spacing or directions are no frame of space
VoxelGrid read_voxel_grid(const std::string& path);

/// The same with its values. \throws InputError as above, and where a value is not finite or a whole number too large
Volume read_volume(const std::string& path);

/// The same with what is chosen in it: a segment's name becomes its label and layer. Of several layers a threshold
/// takes all that are above it in any. \throws InputError as above, where there is no such segment, naming those that
/// there are, and where labels are asked of several layers
VolumePart read_volume_part(const VolumeName& name);

/// Where other programs may place the voxels elsewhere, or the header contradicts itself.
std::vector<std::string> volume_notes(const VoxelGrid& grid);

/// What other programs cannot do with a volume on this grid in a file of this name.
std::vector<std::string> written_notes(const std::string& path, const VoxelGrid& grid);

/// What can be written. \throws InputError naming the formats where the name's ending is none of .nii .nii.gz .nrrd
/// .mha .vti
void check_volume_output(const std::string& path);

/// A volume given in RAS as a file that is still to be published, in its own type of values, rounded and limited to the
/// range of the type; compressed, but for .nii. An NRRD names the unit of its grid. A NIfTI is in millimetres where
/// that unit is a known one, and otherwise says that its unit is unknown. \throws EnvironmentError where it cannot be
/// written, InputError as check_volume_output
PendingFile volume_file(const std::string& path, const Volume& volume, Existing existing);

/// volume_file(), published. \throws as that and PendingFile::publish
inline void write_volume(const std::string& path, const Volume& volume, Existing existing) {
  volume_file(path, volume, existing).publish();
}

/// The same of vectors of single precision, one for each voxel, whose components are along the axes of LPS: as ANTs and
/// ITK read a field of displacements; in .vti along those of RAS. \param values 3 n_voxels, voxel by voxel. \throws as
/// volume_file
PendingFile vector_volume_file(const std::string& path, const VoxelGrid& grid, std::span<const float> values,
                               Existing existing);

}  // namespace shellmatch
