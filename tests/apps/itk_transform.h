#pragma once
/// \file
/// ITK as the users of our fields have it. Without our types: ITK brings an Eigen of its own.

#include <array>
#include <string>
#include <vector>

namespace shellmatch {

using LpsPoint = std::array<double, 3>;

/// The points moved by itk::DisplacementFieldTransform with the field in the file.
std::vector<LpsPoint> moved_by_itk(const std::string& file, const std::vector<LpsPoint>& points);

}  // namespace shellmatch
