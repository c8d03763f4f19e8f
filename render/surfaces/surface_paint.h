#pragma once
/// \file
/// Colour and light at a point of a surface.

#include "render/surfaces/camera.h"
#include "render/surfaces/render_surface.h"

#include <array>
#include <vector>

namespace shellmatch {

class RayScene;

/// A surface with all that shading needs.
class PaintedSurface {
 public:
  explicit PaintedSurface(const RenderSurface& surface);

  /// Share of the sky that each vertex sees among the opaque surfaces in `scene`; `reach` is how far
  /// something may be to darken. Smoothed once over the facets.
  void compute_openness(const RayScene& scene, double reach);

  /// Linear light that the point of barycentric coordinates (u, v) sends to the eye.
  Vec<3> light(const Camera& camera, const Ray& ray, Index facet, double u, double v) const;

  /// How much of what lies behind is hidden; more at the rim of a transparent surface, like glass.
  double opacity(const Ray& ray, Index facet, double u, double v) const;

 private:
  Vec<3> albedo(Index facet, double u, double v) const;
  Vec<3> normal(const Ray& ray, Index facet, double u, double v) const;

  RenderSurface look_;
  std::vector<std::array<Vec<3>, 3>> normals_;
  std::vector<float> openness_;
  std::vector<Vec<3>>
      palette_;  ///< linear light: by scalar in equal steps, by vertex where position paints, or one
  Vec<3> origin_centre_ = Vec<3>::Zero();
  double origin_scale_ = 1;  ///< makes the box's longest half side 1
  double checker_scale_ = 1;
};

}  // namespace shellmatch
