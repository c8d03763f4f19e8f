#pragma once
/// \file
/// The motion of the reference that pairs of points suggest.

#include "alignment/pairs/corresponding_points.h"
#include "geometry/surface/placement.h"
#include "matching/experiment/align_options.h"

#include <string>
#include <vector>

namespace shellmatch {

/// The pose that `options.mode` asks for. With `auto` it is a rigid motion, or a similarity where the sizes differ by more
/// than a quarter, and the identity unless that brings the pairs nearer by options.pose_gain. \pre at least three pairs
Similarity<3> choose_pose(const std::vector<CorrespondingPoints>& pairs, const AlignOptions& options);

/// Of the rotation, in degrees, at most 180; that of the rotation after the mirror image where it is mirrored.
double angle_in_degrees(const Mat<3>& rotation);

/// For the line that tells what was chosen.
std::string pose_text(const Similarity<3>& pose);

}  // namespace shellmatch
