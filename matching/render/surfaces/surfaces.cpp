#include "matching/render/surfaces/surfaces.h"

#include "base/error.h"
#include "base/parallel.h"
#include "matching/render/surfaces/ray_scene.h"
#include "matching/render/surfaces/surface_paint.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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
  const std::vector<RenderSurface> look(surfaces.begin(), surfaces.end());
  return std::move(render_looks(std::span(&look, 1), camera, options).front());
}

std::vector<Image> render_looks(std::span<const std::vector<RenderSurface>> looks, const Camera& camera,
                                const RenderOptions& options) {
  SHELLMATCH_CHECK(options.width > 0 && options.height > 0 && options.samples > 0, "a picture needs an area");
  SHELLMATCH_CHECK(!looks.empty(), "a picture needs a look");
  const std::vector<RenderSurface>& surfaces = looks.front();
  const double size = scene_size(surfaces);
  std::vector<std::vector<PaintedSurface>> painted;  // for each look
  for (const std::vector<RenderSurface>& look : looks) {
    painted.emplace_back(look.begin(), look.end());
    SHELLMATCH_CHECK(std::ranges::equal(look, surfaces,
                                        [](const RenderSurface& a, const RenderSurface& b) {
                                          return a.surface == b.surface && a.opacity == b.opacity;
                                        }),
                     "looks are of the same surfaces");
  }
  std::vector<const Surface<3>*> opaque;
  std::vector<std::size_t> opaque_index;
  std::vector<Layer> layers;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
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
      if (surfaces[i].openness.empty()) {
        const std::vector<float> of_vertices = openness(*surfaces[i].surface, solid, reach_of_shade * size);
        for (std::vector<PaintedSurface>& look : painted) look[i].set_openness(of_vertices);
      }

  const Vec<3> background(linear_from_srgb(options.background.r), linear_from_srgb(options.background.g),
                          linear_from_srgb(options.background.b));
  struct Hits {
    std::optional<RayHit> solid;
    std::vector<std::pair<std::size_t, RayHit>> before = {};  // surface and where, in front of what is solid
  };
  const auto trace = [&](const Ray& ray) {
    Hits hits{solid.first_hit(ray)};
    for (const Layer& layer : layers)
      if (const auto hit = layer.scene.first_hit(ray); hit && (!hits.solid || hit->distance < hits.solid->distance))
        hits.before.emplace_back(layer.surface, *hit);
    return hits;
  };
  const auto light_of = [&](const std::vector<PaintedSurface>& look, const Ray& ray, const Hits& hits) {
    std::vector<Sample> samples;
    Vec<3> light = background;
    if (const auto& hit = hits.solid)
      light = look[opaque_index[hit->surface]].light(camera, ray, hit->facet, hit->u, hit->v);
    for (const auto& [surface, hit] : hits.before) {
      const PaintedSurface& p = look[surface];
      samples.push_back(
          {hit.distance, p.opacity(ray, hit.facet, hit.u, hit.v), p.light(camera, ray, hit.facet, hit.u, hit.v)});
    }
    std::stable_sort(samples.begin(), samples.end(),
                     [](const Sample& a, const Sample& b) { return a.distance > b.distance; });
    for (const Sample& s : samples) light = (1 - s.opacity) * light + s.opacity * s.light;
    return Vec<3>(light.cwiseMin(1.0));
  };

  double clearance = 0;  // parallel rays start in front of all surfaces
  for (const RenderSurface& s : surfaces)
    for (const Vec<3>& v : s.surface->vertices)
      clearance = std::max(clearance, (v - camera.target).dot(camera.backward));
  clearance += size;

  const double pixel = 2.0 / options.height, n_samples = options.samples;
  const auto ray_at = [&](double column, double row) {
    return camera_ray(camera, (column - 0.5 * options.width) * pixel, (0.5 * options.height - row) * pixel, clearance);
  };
  const int width = options.width, height = options.height;
  const std::size_t n_pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<Vec<3>> centres(looks.size() * n_pixels);
  const auto centre = [&](std::size_t look, int column, int row) -> Vec<3>& {
    return centres[look * n_pixels + static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(column)];
  };
  parallel_for(
      static_cast<std::size_t>(height),
      [&](std::size_t row) {
        for (int column = 0; column < width; ++column) {
          const Ray ray = ray_at(column + 0.5, static_cast<double>(row) + 0.5);
          const Hits hits = trace(ray);
          for (std::size_t l = 0; l < looks.size(); ++l)
            centre(l, column, static_cast<int>(row)) = light_of(painted[l], ray, hits);
        }
      },
      4);

  // One ray suffices for a pixel that resembles all its neighbours; pixels at edges are supersampled.
  const auto is_plain = [&](std::size_t look, int column, int row) {
    const Vec<3>& here = centre(look, column, row);
    for (int r = std::max(0, row - 1); r <= std::min(height - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(width - 1, column + 1); ++c)
        if ((centre(look, c, r) - here).cwiseAbs().maxCoeff() > visible_step) return false;
    return true;
  };
  std::vector<Image> images(looks.size(), Image(width, height, options.background));
  parallel_for(
      static_cast<std::size_t>(height),
      [&](std::size_t y) {
        const int row = static_cast<int>(y);
        for (int column = 0; column < width; ++column) {
          std::vector<std::size_t> varied;  // looks
          for (std::size_t l = 0; l < looks.size(); ++l)
            if (options.samples > 1 && !is_plain(l, column, row)) varied.push_back(l);
          std::vector<Vec<3>> sums(varied.size(), Vec<3>::Zero());
          for (int j = 0; j < options.samples && !varied.empty(); ++j)
            for (int i = 0; i < options.samples; ++i) {
              // Each row of samples is shifted: nearly vertical edges get more shades.
              const Ray ray = ray_at(column + (i + (j + 0.5) / n_samples) / n_samples,
                                     row + (j + (i + 0.5) / n_samples) / n_samples);
              const Hits hits = trace(ray);
              for (std::size_t k = 0; k < varied.size(); ++k) sums[k] += light_of(painted[varied[k]], ray, hits);
            }
          for (std::size_t l = 0, k = 0; l < looks.size(); ++l) {
            const bool is_varied = k < varied.size() && varied[k] == l;
            const Vec<3> light = is_varied ? Vec<3>(sums[k++] / (n_samples * n_samples)) : centre(l, column, row);
            if (light == background) continue;
            images[l].set(column, row,
                          {srgb_from_linear(light[0]), srgb_from_linear(light[1]), srgb_from_linear(light[2])});
          }
        }
      },
      4);
  return images;
}

}  // namespace shellmatch
