#pragma once
/// \file
/// Where the segments of an outline meet although they should not.

#include "geometry/surface/surface.h"

#include <utility>
#include <vector>

namespace shellmatch {

/// All pairs (f < g) of segments that share a point other than a common end. Exact test, sorted.
std::vector<std::pair<Index, Index>> crossing_segments(const Surface<2>& outline);

/// All pairs of a segment and a vertex that lies exactly within it, between its ends; sorted by segment and
/// from its first end on.
std::vector<std::pair<Index, Index>> touching_vertices(const Surface<2>& outline);

/// A point that both segments have, up to rounding.
Vec<2> crossing_point(const Surface<2>& outline, Index f, Index g);

}  // namespace shellmatch
