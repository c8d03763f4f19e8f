#pragma once
/// \file
/// An outline whose y counts rows downward beside the picture that it belongs to.

#include "geometry/surface/surface.h"

#include <string>

namespace shellmatch {

/// What two closed outlines have in common, as a share of the area that either has: 1 where they are the same. By
/// intervals along 1000 lines.
double common_share(const Surface<2>& a, const Surface<2>& b);

/// Where an outline fits that of a picture far better with y = height - y of its file than as it is (common_share at
/// least 0.6 and 0.1 more, and a third of what is missing): the outline is turned, its frame, by which its landmarks
/// follow, and the words for it are returned. Else nothing changes. \param height of the picture
std::string turn_downward_outline(Shape<2>& outline, const Shape<2>& picture, double height);

}  // namespace shellmatch
