#pragma once
/// \file
/// From a shape as it was read to the closed, welded, outward oriented surface that all computations use.

#include "geometry/surface/surface.h"

#include <string>
#include <vector>

namespace shellmatch {

/// Triangulates polygons, welds open seams whose vertices have equal coordinates, removes repeated triangles
/// and triangles without area, splits vertices where the surface touches itself, orients all triangles
/// consistently and every connected part outward, or into the cavity where it lies within an odd number of
/// other parts. Says in `notes` what it did. \param source the name for messages. \throws InputError where
/// there are no faces, where the surface stays open (how many boundary edges and loops, where), has an edge
/// with more than two triangles (how many, where), is one-sided or encloses no volume.
Surface<3> mend_surface(const OriginalShape<3>& original, const std::string& source,
                        std::vector<std::string>& notes);

/// Joins every ring's last point with its first, removes repeated points and spikes without width, cuts rings
/// in two where they visit a point twice, and orients rings by their depth of nesting: outer ones
/// counter-clockwise, holes clockwise. \throws InputError where a ring has fewer than three points or no
/// area, or where segments cross or touch at other places than common points (the segments by the numbers of
/// their points, counted from 1, and the place).
Surface<2> mend_outline(const OriginalShape<2>& original, const std::string& source,
                        std::vector<std::string>& notes);

}  // namespace shellmatch
