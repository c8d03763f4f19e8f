#pragma once
/// \file
/// The rigid motion or similarity that carries the points of pairs onto each other, robust to wrong pairs.

#include "alignment/pairs/corresponding_points.h"
#include "geometry/surface/placement.h"

#include <span>

namespace shellmatch {

/// x -> scale * rotation * x + translation, from the reference to the template.
struct Pose {
  Mat<3> rotation = Mat<3>::Identity();  ///< orthogonal; its determinant is -1 where the pose is mirrored
  double scale = 1;
  Vec<3> translation = Vec<3>::Zero();
  double residual = 0;  ///< median distance of the pairs after it, in the unit of the template

  Vec<3> operator()(const Vec<3>& x) const { return scale * (rotation * x) + translation; }
  Vec<3> inverse(const Vec<3>& y) const { return rotation.transpose() * (y - translation) / scale; }
  Similarity<3> similarity() const { return {scale, translation, rotation}; }
  bool is_mirrored() const;
};

enum class PoseKind { rigid, similarity };

/// Whether a pose reverses orientation. With `allowed` it does where its residual is below two thirds of that of the
/// best proper one.
enum class Mirroring { never, allowed, always };
constexpr double mirrored_gain = 2.0 / 3;

/// The pose of least median of squares over fixed random triples of pairs (Rousseeuw, J. Am. Stat. Assoc. 79, 1984),
/// improved by reweighted least squares with Tukey's biweight. Up to two fifths of the pairs may be anywhere.
/// \throws InputError with fewer than three pairs, and where the points of either side lie on a line
Pose fit_pose(std::span<const CorrespondingPoints> pairs, PoseKind kind, Mirroring mirroring = Mirroring::never);

/// Of weighted least squares, in closed form. A rigid motion has scale 1. Poses of either handedness are
/// compared by their root mean square distances.
/// \throws InputError with fewer than two pairs of a weight, and where the points of either side coincide
Similarity<2> fit_planar_pose(std::span<const CorrespondingPointsIn<2>> pairs, PoseKind kind,
                              Mirroring mirroring = Mirroring::never);

}  // namespace shellmatch
