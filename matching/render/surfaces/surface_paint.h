#pragma once
/// \file
/// Shading of a point of a surface.

#include "geometry/surface/surface.h"
#include "matching/render/surfaces/camera.h"
#include "matching/render/surfaces/render_surface.h"

#include <array>
#include <utility>
#include <vector>

namespace shellmatch {

/// Unit normals at the three corners of every facet: area-weighted means over the facets at the vertex whose
/// normals form an angle of at most `crease_angle` degrees with that of the facet. Round parts are then
/// shaded smoothly and edges stay sharp. An angle of 0 yields facet normals. Facets without area have zero
/// normals.
std::vector<std::array<Vec<3>, 3>> corner_normals(const Surface<3>& surface, double crease_angle);

class RayScene;

/// Ambient occlusion: the share of the sky that is visible from each vertex among the surfaces in `scene`, of which
/// those within the distance `reach` count. Smoothed once over the facets.
std::vector<float> openness(const Surface<3>& surface, const RayScene& scene, double reach);

/// A surface with the data for its shading.
class PaintedSurface {
 public:
  explicit PaintedSurface(const RenderSurface& surface);

  /// One for each vertex; without, nothing is shaded but what RenderSurface::openness tells.
  void set_openness(std::vector<float> openness) { look_.openness = std::move(openness); }

  /// Linear light from the point with barycentric coordinates (u, v) of the facet towards the eye.
  Vec<3> light(const Camera& camera, const Ray& ray, Index facet, double u, double v) const;

  /// Opacity at this point. For transparent surfaces it increases towards the silhouette, as for glass.
  double opacity(const Ray& ray, Index facet, double u, double v) const;

 private:
  Vec<3> albedo(Index facet, double u, double v) const;
  Vec<3> normal(const Ray& ray, Index facet, double u, double v) const;

  RenderSurface look_;
  std::vector<std::array<Vec<3>, 3>> normals_;
  std::vector<Vec<3>> palette_;  ///< linear light: by scalar in equal steps, by vertex for position and checker, or one
  Vec<3> origin_centre_ = Vec<3>::Zero();
  double origin_scale_ = 1;  ///< scales the longest half side of the box to 1
  double checker_scale_ = 1;
};

}  // namespace shellmatch
