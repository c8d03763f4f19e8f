#pragma once
/// \file
/// Repair of a shape as read: conversion to the closed, welded, outward oriented surface of the computations.

#include "geometry/surface/surface.h"

#include <string>
#include <vector>

namespace shellmatch {

/// What happens to a surface with holes, or whose edges have more than two triangles.
enum class Closing { never, automatic };

/// A closed surface, and what of it was made up.
struct MendedSurface {
  Surface<3> surface;
  Evidence<3> evidence;
  double invented_share = 0;    ///< of the area
  std::vector<Index> crossing;  ///< Shape::crossing
};

/// Triangulates polygons, welds open seams whose vertices have equal coordinates, removes repeated triangles
/// and triangles without area, splits vertices where the surface touches itself, orients all triangles
/// consistently and every connected part outward, or into the cavity where it lies within an odd number of
/// other parts. Describes the repairs in `notes`. \param source the name for messages. \throws InputError
/// where there are no faces, where the surface remains open (with the numbers of boundary edges and loops,
/// and a position), has an edge with more than two triangles (with the number, and a position), is one-sided
/// or encloses no volume. With Closing::automatic holes that make up at most 45 % of the area are filled, and
/// everything else that is not closed is wrapped; it is then refused only where the wrap encloses next to nothing.
MendedSurface mend_surface(const OriginalShape<3>& original, const std::string& source, std::vector<std::string>& notes,
                           Closing closing = Closing::never);

/// Closes every ring, removes repeated points and spikes without width, splits rings that visit a point
/// twice, and orients rings by their depth of nesting: outer ones counter-clockwise, holes clockwise. \throws
/// InputError where a ring has fewer than three points or no area, or where segments meet elsewhere than at
/// common points (with the numbers of their points, counted from 1, and the position) or rings cross at a common point.
Surface<2> mend_outline(const OriginalShape<2>& original, const std::string& source, std::vector<std::string>& notes);

}  // namespace shellmatch
