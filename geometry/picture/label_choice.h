#pragma once
/// \file
/// What is chosen of a volume or a picture: the text after the colon of "scan.nii.gz:3", "mask.png:1,2",
/// "map.mha:>0.5".

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// Whole numbers beyond this are not told apart: values are kept in single precision.
inline constexpr double largest_label = 16777216;

/// The voxels or pixels that make up a shape. Without labels: those above `above`.
struct VoxelChoice {
  std::vector<double> labels;
  double above = 0;
  std::string segment =
      {};  ///< of an NRRD, by its name: read_volume_part() (geometry/volume/volume_file.h) finds its label

  bool contains(float value) const;
  /// "label 3", "labels 1, 2", "everything above 0"
  std::string text() const;
};

/// \param source the whole name, for messages \param example a file's name, for messages
/// \throws InputError where the text cannot be understood
VoxelChoice parse_choice(std::string_view text, const std::string& source, std::string_view example);

}  // namespace shellmatch
