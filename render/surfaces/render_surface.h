#pragma once
/// \file
/// A surface as it is drawn: its colours, its opacity and its shading.

#include "geometry/surface/surface.h"
#include "render/canvas/color.h"

#include <vector>

namespace shellmatch {

/// What the colour of a surface tells.
enum class Paint {
  uniform,   ///< RenderSurface::color
  scalar,    ///< RenderSurface::scalars through a colour map
  position,  ///< soft colours by RenderSurface::origins
  checker,   ///< the same with a three-dimensional checkerboard: a pattern that a deformation carries along
};

/// A surface and how it looks. Holds no copy: `surface` must outlive the call.
struct RenderSurface {
  const Surface<3>* surface = nullptr;
  Paint paint = Paint::uniform;
  Color color{0.72, 0.75, 0.80};
  double opacity = 1;        ///< below 1 only the part next to the eye shows, what lies behind shines through
  double crease_angle = 35;  ///< degrees; edges sharper than this stay sharp, 0 shows the facets
  std::vector<double> scalars = {};  ///< one per vertex
  double scalar_min = 0, scalar_max = 1;
  ColorMap color_map = ColorMap::sequential;
  /// One per vertex: where it was in the reference shape; empty: where it is.
  std::vector<Vec<3>> origins = {};
  Box<3> origin_box = {};     ///< box that the pattern's colours span; if empty, that of the origins
  double checker_cells = 14;  ///< along the box's diagonal
};

}  // namespace shellmatch
