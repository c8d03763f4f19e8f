#pragma once
/// \file
/// ITK as the users of our fields have it. Without our types: ITK brings an Eigen of its own.

#include <array>
#include <string>
#include <vector>

namespace shellmatch {

/// 502 for 5.2.
int itk_version();

using LpsPoint = std::array<double, 3>;

/// The points moved by itk::DisplacementFieldTransform with the field in the file.
std::vector<LpsPoint> moved_by_itk(const std::string& file, const std::vector<LpsPoint>& points);

/// Where ITK's reader of the format (by the ending) has the voxel, and its value.
struct ItkVoxel {
  LpsPoint position;
  double value;
};
ItkVoxel voxel_by_itk(const std::string& file, const std::array<int, 3>& index);

}  // namespace shellmatch
