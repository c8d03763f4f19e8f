#pragma once
/// \file
/// The rigid motion or similarity that carries the points of pairs onto each other, robust to wrong pairs.

#include "alignment/pairs/corresponding_points.h"
#include "geometry/surface/placement.h"

#include <span>

namespace shellmatch {

/// x -> scale * rotation * x + translation, from the reference to the template.
struct Pose {
  Mat<3> rotation = Mat<3>::Identity();  ///< orthogonal; its determinant is -1 where a mirror is allowed and fits better
  double scale = 1;
  Vec<3> translation = Vec<3>::Zero();
  double residual = 0;  ///< median distance of the pairs after it, in the unit of the template

  Vec<3> operator()(const Vec<3>& x) const { return scale * (rotation * x) + translation; }
  Vec<3> inverse(const Vec<3>& y) const { return rotation.transpose() * (y - translation) / scale; }
  Similarity<3> similarity() const { return {scale, translation, rotation}; }
  bool is_mirrored() const;
};

enum class PoseKind { rigid, similarity };

/// The pose of least median of squares over fixed random triples of pairs (Rousseeuw, J. Am. Stat. Assoc. 79, 1984),
/// improved by reweighted least squares with Tukey's biweight. Up to two fifths of the pairs may be anywhere. A mirrored
/// pose is returned only with `allow_mirror`, and where its residual is below two thirds of that of the best proper one.
/// \throws InputError with fewer than three pairs, and where the points of either side lie on a line
Pose fit_pose(std::span<const CorrespondingPoints> pairs, PoseKind kind, bool allow_mirror = false);

}  // namespace shellmatch
