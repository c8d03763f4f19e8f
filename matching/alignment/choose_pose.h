#pragma once
/// \file
/// The motion of the reference that pairs of points suggest.

#include "alignment/pairs/corresponding_points.h"
#include "alignment/pose/fit_pose.h"
#include "geometry/surface/placement.h"
#include "matching/experiment/align_options.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// The pose that `options.mode` asks for. With `auto` it is a rigid motion, or a similarity where the sizes differ by
/// more than a quarter, and the identity unless that brings the pairs nearer by options.pose_gain. Of fifty pairs or
/// more the sizes are compared by distances between neighbours: the best similarity between a body that stands and one
/// that crouches halves it. With `landmarks`, a similarity. \throws InputError where the points determine no pose
template <int Dim>
Similarity<Dim> choose_pose(const std::vector<CorrespondingPointsIn<Dim>>& pairs, const AlignOptions& options,
                            Mirroring mirroring);

/// Of the rotation, in degrees, at most 180. Where it is mirrored, of the rotation after a reflection: in space at the
/// origin, in the plane at the x axis.
template <int Dim>
double angle_in_degrees(const Mat<Dim>& rotation);

/// For the line that tells what was chosen. \param moved "reference", or "template" where that is deformed
template <int Dim>
std::string pose_text(const Similarity<Dim>& pose, std::string_view moved);

}  // namespace shellmatch
