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

/// Whether the path a - p - b passes through the path c - p - d at p, from one side of it to the other. Exact test.
/// \pre no two of the four ends lie in the same direction from p
bool pass_through_at(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d);

/// A common point of both segments, up to rounding.
Vec<2> crossing_point(const Surface<2>& outline, Index f, Index g);

}  // namespace shellmatch
