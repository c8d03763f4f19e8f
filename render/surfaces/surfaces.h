#pragma once
/// \file
/// Pictures of surfaces in space, by ray casting: no display is needed.

#include "render/surfaces/camera.h"
#include "render/canvas/image.h"

#include <span>
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

struct RenderOptions {
  int width = 640, height = 640;  ///< pixels
  int samples = 4;                ///< along each side of a pixel
  bool ambient_occlusion = true;  ///< soft shade in hollows
  Color background = white;
};

/// The surfaces as the camera sees them: smooth shading, key light from the upper left, fill light, no cast
/// shadows. The same bits whatever the number of threads.
/// \pre scalars and origins are empty or have one entry for each vertex.
Image render_surfaces(std::span<const RenderSurface> surfaces, const Camera& camera,
                      const RenderOptions& options = {});

}  // namespace shellmatch
