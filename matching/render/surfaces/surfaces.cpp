#include "matching/render/surfaces/surfaces.h"

#include "base/error.h"
#include "base/parallel.h"
#include "matching/render/surfaces/ray_scene.h"
#include "matching/render/surfaces/surface_paint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

// A transparent surface. Each has its own scene, so that only its front layer is hit.
struct Layer {
  std::size_t surface;
  RayScene scene;
};

/// Difference of linear light between neighbouring pixels above which they are supersampled.
constexpr double visible_step = 0.02;

/// Surfaces farther away shade nothing, in diagonals of the scene.
constexpr double reach_of_shade = 0.2;

struct Sample {
  double distance, opacity;
  Vec<3> light;
};

double scene_size(std::span<const RenderSurface> surfaces) {
  Box<3> box;
  for (const RenderSurface& s : surfaces)
    for (const Vec<3>& v : s.surface->vertices) box.add(v);
  return surfaces.empty() ? 1 : std::max(1e-12, box.diagonal());
}

}  // namespace

std::vector<float> surface_openness(const Surface<3>& surface) {
  const Surface<3>* one = &surface;
  return openness(surface, RayScene(std::span(&one, 1)), reach_of_shade * bounding_box(surface.vertices).diagonal());
}

Image render_surfaces(std::span<const RenderSurface> surfaces, const Camera& camera, const RenderOptions& options) {
  SHELLMATCH_CHECK(options.width > 0 && options.height > 0 && options.samples > 0, "a picture needs an area");
  const double size = scene_size(surfaces);
  std::vector<PaintedSurface> painted;
  std::vector<const Surface<3>*> opaque;
  std::vector<std::size_t> opaque_index;
  std::vector<Layer> layers;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    painted.emplace_back(surfaces[i]);
    const Surface<3>* s = surfaces[i].surface;
    if (surfaces[i].opacity >= 1) {
      opaque.push_back(s);
      opaque_index.push_back(i);
    } else {
      layers.push_back({i, RayScene(std::span(&s, 1))});
    }
  }
  const RayScene solid(opaque);
  if (options.ambient_occlusion)
    for (const std::size_t i : opaque_index)
      if (surfaces[i].openness.empty())
        painted[i].set_openness(openness(*surfaces[i].surface, solid, reach_of_shade * size));

  const Vec<3> background(linear_from_srgb(options.background.r), linear_from_srgb(options.background.g),
                          linear_from_srgb(options.background.b));
  const auto trace = [&](const Ray& ray) {
    std::vector<Sample> samples;
    Vec<3> light = background;
    double solid_distance = std::numeric_limits<double>::infinity();
    if (const auto hit = solid.first_hit(ray)) {
      light = painted[opaque_index[hit->surface]].light(camera, ray, hit->facet, hit->u, hit->v);
      solid_distance = hit->distance;
    }
    for (const Layer& layer : layers)
      if (const auto hit = layer.scene.first_hit(ray); hit && hit->distance < solid_distance) {
        const PaintedSurface& p = painted[layer.surface];
        samples.push_back({hit->distance, p.opacity(ray, hit->facet, hit->u, hit->v),
                           p.light(camera, ray, hit->facet, hit->u, hit->v)});
      }
    std::stable_sort(samples.begin(), samples.end(),
                     [](const Sample& a, const Sample& b) { return a.distance > b.distance; });
    for (const Sample& s : samples) light = (1 - s.opacity) * light + s.opacity * s.light;
    return light;
  };

  double clearance = 0;  // parallel rays start in front of all surfaces
  for (const RenderSurface& s : surfaces)
    for (const Vec<3>& v : s.surface->vertices)
      clearance = std::max(clearance, (v - camera.target).dot(camera.backward));
  clearance += size;

  const double pixel = 2.0 / options.height, n_samples = options.samples;
  const auto light_at = [&](double column, double row) {
    const Ray ray =
        camera_ray(camera, (column - 0.5 * options.width) * pixel, (0.5 * options.height - row) * pixel, clearance);
    return Vec<3>(trace(ray).cwiseMin(1.0));
  };
  const int width = options.width, height = options.height;
  std::vector<Vec<3>> centres(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto centre = [&](int column, int row) -> Vec<3>& {
    return centres[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  };
  parallel_for(
      static_cast<std::size_t>(height),
      [&](std::size_t row) {
        for (int column = 0; column < width; ++column)
          centre(column, static_cast<int>(row)) = light_at(column + 0.5, static_cast<double>(row) + 0.5);
      },
      4);

  // One ray suffices for a pixel that resembles all its neighbours; pixels at edges are supersampled.
  const auto is_plain = [&](int column, int row) {
    const Vec<3>& here = centre(column, row);
    for (int r = std::max(0, row - 1); r <= std::min(height - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(width - 1, column + 1); ++c)
        if ((centre(c, r) - here).cwiseAbs().maxCoeff() > visible_step) return false;
    return true;
  };
  Image image(width, height, options.background);
  parallel_for(
      static_cast<std::size_t>(height),
      [&](std::size_t y) {
        const int row = static_cast<int>(y);
        for (int column = 0; column < width; ++column) {
          Vec<3> light = centre(column, row);
          if (options.samples > 1 && !is_plain(column, row)) {
            light.setZero();
            for (int j = 0; j < options.samples; ++j)
              for (int i = 0; i < options.samples; ++i)
                // Each row of samples is shifted: nearly vertical edges get more shades.
                light += light_at(column + (i + (j + 0.5) / n_samples) / n_samples,
                                  row + (j + (i + 0.5) / n_samples) / n_samples);
            light /= n_samples * n_samples;
          }
          image.set(column, row, {srgb_from_linear(light[0]), srgb_from_linear(light[1]), srgb_from_linear(light[2])});
        }
      },
      4);
  return image;
}

}  // namespace shellmatch
