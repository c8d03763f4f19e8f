#pragma once
/// \file
/// Values of a volume between its voxels.

#include "geometry/volume/volume.h"

#include <cstddef>

namespace shellmatch {

/// nearest: of the voxel that holds the point. label: the value that has the greatest share around the point, by a
/// cubic B-spline for each, as the surfaces of labels are made (smoothed_label.h): borders between labels get no
/// stairs. linear: between eight voxels.
enum class Sampling { nearest, label, linear };

/// Whether the values are those of labels: whole numbers, at most 100 different ones and none negative.
bool is_label_volume(const Volume& volume);

class VolumeSampler {
 public:
  /// \param volume must outlive this object
  VolumeSampler(const Volume& volume, Sampling sampling);

  /// The value at a point in RAS; `background` where no voxel holds it.
  float operator()(const Vec<3>& x, float background) const;

 private:
  float label_at(const Vec<3>& index) const;
  float linear_at(const Vec<3>& index) const;

  const Volume* volume_;
  Sampling sampling_;
  Mat<3> to_index_;
};

}  // namespace shellmatch
