#pragma once
/// \file
/// Intersections of the segments of an outline.

#include "geometry/surface/surface.h"

#include <utility>
#include <vector>

namespace shellmatch {

/// Pairs (f < g) of segments that share a point other than a common end, or an inner point of both. Exact test, sorted.
/// \param most the search ends where more than so many are found: n segments may cross n (n - 1) / 2 times
enum class Contact { any, of_inner_points };
std::vector<std::pair<Index, Index>> crossing_segments(const Surface<2>& outline, Contact contact, std::size_t most);

/// All pairs of a segment and a vertex in its interior (exact test), sorted by segment and along the segment.
std::vector<std::pair<Index, Index>> touching_vertices(const Surface<2>& outline);

/// A common point of both segments, up to rounding.
Vec<2> crossing_point(const Surface<2>& outline, Index f, Index g);

}  // namespace shellmatch
