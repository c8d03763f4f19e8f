#pragma once
/// \file
/// The frame of a mesh that names none, told by points of 3D Slicer that lie on it: those do name one.

#include "geometry/surface/surface.h"
#include "matching/pairs/slicer_points.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

using PointImage = std::function<std::optional<Vec<3>>(const Vec<3>&)>;

/// What 3D Slicer since 4.11 takes a mesh for that names no frame.
inline constexpr Space slicer_default_space = Space::lps;

/// The frame in which the points lie on the surface, by the median of their distances. Unsaid where they do in both, in
/// neither, or where the surface has no facets.
Space frame_of_points(const Surface<3>& surface, const SlicerPoints& file);

/// The same of some points, `points` in `own`; many are thinned. \pre own is said
/// \param image where a point in the frame of the surface is asked for, which may be nowhere; null for itself
Space frame_of_points(const Surface<3>& surface, const std::vector<Vec<3>>& points, Space own,
                      const PointImage& image = nullptr);

/// The positions of a file's points in one frame, without those that have none.
std::vector<Vec<3>> positions_in(Space space, const SlicerPoints& file);

/// The frame in which a shape and its file of points are read: that which the shape names; where it names none and the
/// file is one of Slicer's, that in which the points lie on it, or Slicer's own. \param wanted by the user for shapes
/// that name none; or unsaid
template <int Dim>
Space space_beside(const OriginalShape<Dim>& shape, const std::string& points, Space wanted);

}  // namespace shellmatch
