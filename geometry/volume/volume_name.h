#pragma once
/// \file
/// Names of shapes that are parts of volumes: "scan.nii.gz", "scan.nii.gz:3", "scan.nrrd:1,2", "map.mha:>0.5",
/// "scan.seg.nrrd:Femur".

#include "geometry/picture/label_choice.h"
#include "geometry/volume/volume.h"

#include <optional>
#include <string>

namespace shellmatch {

/// What makes a shape of a volume: its voxels, and which of them.
struct VolumePart {
  Volume volume;
  VoxelChoice choice;
};

struct VolumeName {
  std::string file;
  VoxelChoice choice;
};

/// Whether the name's ending is that of a volume: .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd, .vti, in capitals, too.
bool is_volume_file(const std::string& path);

enum class VolumeFormat { nifti, nrrd, meta_image, vti };

/// By the ending. \throws InputError where it is no volume's
VolumeFormat volume_format(const std::string& path);

/// The endings, for messages.
inline constexpr const char* volume_endings = ".nii .nii.gz .nrrd .nhdr .mha .mhd .vti";

/// Splits the name of a file from what is chosen in it, at the last colon. None where the name, without what is chosen,
/// has not the ending of a volume: a colon elsewhere belongs to the name. \throws InputError where what is chosen
/// cannot be understood
std::optional<VolumeName> parse_volume_name(const std::string& source);

/// The file of a shape's name: without what is chosen of a volume.
std::string file_of(const std::string& source);

}  // namespace shellmatch
