#pragma once
/// \file
/// The level set of a label: a smooth function whose zero level has the label's volume and none of its stairs.

#include "geometry/label/label_region.h"

#include <cstdint>
#include <vector>

namespace shellmatch {

/// The smoothing's standard deviation in voxels, along each axis of the volume.
inline constexpr double label_smoothing = 0.73;

/// The label's share of space around a point: the cubic B-spline whose coefficients are the voxels' shares after a step
/// of a discrete Gaussian. The spline spreads a voxel with the variance 1/3, the step adds 1/5; it is twice
/// continuously differentiable.
class SmoothedLabel {
 public:
  /// \param region must outlive this object
  explicit SmoothedLabel(const LabelRegion& region);

  /// From 0 to 1. \param index coordinates of a point in voxels of the region's grid; outside the share is 0
  double share(const Vec<3>& index) const;

  /// The share on the surface. The space where it is greater has the volume of the voxels.
  double level() const { return level_; }

  /// The greatest share at a voxel's centre.
  double largest_share() const;

  /// For the coordinates of a point: no point closer than so many voxels along every axis is on the surface. 0 near it.
  double clearance(const Vec<3>& index) const;

 private:
  void find_level(const LabelRegion& region);
  void find_clearance();

  std::array<int, 3> size_;
  std::vector<float> coefficients_;
  std::vector<std::uint8_t> clearance_;  ///< voxels to the nearest one whose share is neither 0 nor 1, at most 255
  double level_ = 0.5;
};

}  // namespace shellmatch
