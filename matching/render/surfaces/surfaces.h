#pragma once
/// \file
/// Pictures of surfaces in space by ray casting, without a display.

#include "matching/render/canvas/image.h"
#include "matching/render/surfaces/camera.h"
#include "matching/render/surfaces/render_surface.h"

#include <span>
#include <vector>

namespace shellmatch {

struct RenderOptions {
  int width = 640, height = 640;  ///< pixels
  int samples = 4;                ///< along each side of a pixel
  bool ambient_occlusion = true;  ///< darkens concave parts; RenderSurface::openness counts in any case
  Color background = white;
};

/// Ambient occlusion of a surface alone: the share of the sky that is visible from each vertex.
std::vector<float> surface_openness(const Surface<3>& surface);

/// Renders the surfaces as seen by the camera: smooth shading, key light from the upper left, fill light, no
/// cast shadows. The result does not depend on the number of threads.
/// \pre scalars and origins are empty or have one entry for each vertex.
Image render_surfaces(std::span<const RenderSurface> surfaces, const Camera& camera, const RenderOptions& options = {});

/// The same for several looks of the same surfaces, whose rays are traced once for all. \pre there is a look, and all
/// have the surfaces and opacities of the first
std::vector<Image> render_looks(std::span<const std::vector<RenderSurface>> looks, const Camera& camera,
                                const RenderOptions& options = {});

}  // namespace shellmatch
