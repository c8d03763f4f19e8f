#pragma once
/// \file
/// The rigid motion or similarity of the plane that carries the points of pairs onto each other.

#include "alignment/pairs/corresponding_points.h"
#include "alignment/pose/fit_pose.h"
#include "geometry/surface/placement.h"

#include <span>

namespace shellmatch {

/// Of weighted least squares, in closed form. A rigid motion has scale 1. Poses of either handedness are
/// compared by their root mean square distances.
/// \throws InputError with fewer than two pairs of a weight, and where the points of either side coincide
Similarity<2> fit_planar_pose(std::span<const CorrespondingPointsIn<2>> pairs, PoseKind kind,
                              Mirroring mirroring = Mirroring::never);

}  // namespace shellmatch
