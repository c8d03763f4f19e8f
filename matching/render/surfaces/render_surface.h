#pragma once
/// \file
/// A surface as it is drawn: its colours, its opacity and its shading.

#include "geometry/surface/surface.h"
#include "matching/render/canvas/color.h"

#include <vector>

namespace shellmatch {

/// What determines the colour of a surface.
enum class Paint {
  uniform,   ///< RenderSurface::color
  scalar,    ///< RenderSurface::scalars through a colour map
  position,  ///< position_color() of RenderSurface::origins
  checker,   ///< the same, modulated by a three-dimensional checkerboard of the origins
};

/// A surface and its style. Keeps a pointer: `surface` must outlive the call.
struct RenderSurface {
  const Surface<3>* surface = nullptr;
  Paint paint = Paint::uniform;
  Color color{0.72, 0.75, 0.80};
  double opacity = 1;                ///< below 1, only the front layer is drawn, over what lies behind it
  double crease_angle = 35;          ///< degrees; edges sharper than this stay sharp, 0 shows the facets
  std::vector<double> scalars = {};  ///< one per vertex
  double scalar_min = 0, scalar_max = 1;
  ColorMap color_map = ColorMap::sequential;
  /// One per vertex: its position in the reference shape. If empty, the positions of the vertices.
  std::vector<Vec<3>> origins = {};
  Box<3> origin_box = {};     ///< box that the range of colours spans; if empty, that of the origins
  double checker_cells = 14;  ///< along the box's diagonal
  /// One per vertex, surface_openness(), for several pictures of a surface; if empty, each picture computes its own.
  std::vector<float> openness = {};
};

}  // namespace shellmatch
