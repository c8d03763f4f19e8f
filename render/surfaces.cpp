#include "render/surfaces.h"

#include "base/error.h"
#include "base/parallel.h"
#include "render/ray_scene.h"
#include "render/surface_paint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

// Transparent surfaces have a scene each, so that only the part of it next to the eye is met.
struct Layer {
  std::size_t surface;
  RayScene scene;
};

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

Image render_surfaces(std::span<const RenderSurface> surfaces, const Camera& camera,
                      const RenderOptions& options) {
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
    for (const std::size_t i : opaque_index) painted[i].compute_openness(solid, 0.2 * size);

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

  double clearance = 0;  // parallel rays start in front of everything
  for (const RenderSurface& s : surfaces)
    for (const Vec<3>& v : s.surface->vertices)
      clearance = std::max(clearance, (v - camera.target).dot(camera.backward));
  clearance += size;

  Image image(options.width, options.height, options.background);
  const double pixel = 2.0 / options.height, n_samples = options.samples;
  parallel_for(
      static_cast<std::size_t>(options.height),
      [&](std::size_t row) {
        for (int column = 0; column < options.width; ++column) {
          Vec<3> sum = Vec<3>::Zero();
          for (int j = 0; j < options.samples; ++j)
            for (int i = 0; i < options.samples; ++i) {
              // Each row of samples is shifted a little: edges that are nearly upright get more shades.
              const double sx = (i + (j + 0.5) / n_samples) / n_samples,
                           sy = (j + (i + 0.5) / n_samples) / n_samples;
              const double x = (column + sx - 0.5 * options.width) * pixel;
              const double y = (0.5 * options.height - static_cast<double>(row) - sy) * pixel;
              sum += trace(camera_ray(camera, x, y, clearance)).cwiseMin(1.0);
            }
          sum /= n_samples * n_samples;
          image.set(column, static_cast<int>(row),
                    {srgb_from_linear(sum[0]), srgb_from_linear(sum[1]), srgb_from_linear(sum[2])});
        }
      },
      4);
  return image;
}

}  // namespace shellmatch
