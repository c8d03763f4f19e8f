#include "matching/render/surfaces/surface_paint.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "matching/render/surfaces/ray_scene.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

namespace shellmatch {

namespace {

// Normals whose length is twice the area of the facet.
std::vector<Vec<3>> facet_normals(const Surface<3>& surface) {
  std::vector<Vec<3>> normals(surface.facets.size());
  parallel_for(normals.size(), [&](std::size_t f) { normals[f] = facet_normal(surface, static_cast<Index>(f)); });
  return normals;
}

}  // namespace

std::vector<std::array<Vec<3>, 3>> corner_normals(const Surface<3>& surface, double crease_angle) {
  const std::vector<Vec<3>> facet = facet_normals(surface);
  // The facets at vertex v are around[first[v]] to around[first[v + 1] - 1].
  std::vector<std::size_t> first(surface.vertices.size() + 1, 0);
  for (const auto& corners : surface.facets)
    for (const Index v : corners) ++first[v + 1];
  for (std::size_t v = 0; v + 1 < first.size(); ++v) first[v + 1] += first[v];
  std::vector<std::size_t> around(first.back()), next(first.begin(), first.end() - 1);
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (const Index v : surface.facets[f]) around[next[v]++] = f;

  const double least = std::cos(crease_angle * std::numbers::pi / 180);
  std::vector<std::array<Vec<3>, 3>> normals(surface.facets.size());
  parallel_for(normals.size(), [&](std::size_t f) {
    const Vec<3> own = facet[f].normalized();
    for (int k = 0; k < 3; ++k) {
      const Index v = surface.facets[f][k];
      Vec<3> sum = facet[f];
      for (std::size_t i = first[v]; i < first[v + 1]; ++i)
        if (const Vec<3>& n = facet[around[i]]; around[i] != f && n.dot(own) > least * n.norm()) sum += n;
      normals[f][k] = sum.normalized();
    }
  });
  return normals;
}

namespace {

// Size of the table of colours. Computing them for every ray took a fifth of the time of a picture.
constexpr int n_shades = 4096;

// x^40, a narrow highlight.
double highlight(double x) {
  const double x2 = x * x, x4 = x2 * x2, x8 = x4 * x4, x16 = x8 * x8;
  return x16 * x16 * x8;
}

// Nearly uniform directions on the sphere, along a golden spiral. They are the same for every vertex, so that
// the shade varies smoothly.
std::vector<Vec<3>> sphere_directions(int n) {
  std::vector<Vec<3>> directions(n);
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z);
    directions[i] = {r * std::cos(turn * i), r * std::sin(turn * i), z};
  }
  return directions;
}

Vec<3> linear(const Color& c) { return {linear_from_srgb(c.r), linear_from_srgb(c.g), linear_from_srgb(c.b)}; }

template <class T>
T interpolate(const std::vector<T>& values, const std::array<Index, 3>& corners, double u, double v) {
  return (1 - u - v) * values[corners[0]] + u * values[corners[1]] + v * values[corners[2]];
}

}  // namespace

PaintedSurface::PaintedSurface(const RenderSurface& surface) : look_(surface) {
  const std::size_t n = look_.surface->vertices.size();
  SHELLMATCH_CHECK(look_.scalars.empty() || look_.scalars.size() == n, "one scalar for each vertex");
  SHELLMATCH_CHECK(look_.origins.empty() || look_.origins.size() == n, "one origin for each vertex");
  SHELLMATCH_CHECK(look_.openness.empty() || look_.openness.size() == n, "one openness for each vertex");
  SHELLMATCH_CHECK(look_.paint != Paint::scalar || look_.scalars.size() == n, "painting scalars needs scalars");
  normals_ = corner_normals(*look_.surface, look_.crease_angle);
  if (look_.paint == Paint::position || look_.paint == Paint::checker) {
    if (look_.origins.empty()) look_.origins = look_.surface->vertices;
    const Box<3> box = (look_.origin_box.min.array() <= look_.origin_box.max.array()).all()
                           ? look_.origin_box
                           : bounding_box(look_.origins);
    const double half = 0.5 * (box.max - box.min).maxCoeff();
    origin_centre_ = 0.5 * (box.min + box.max);
    origin_scale_ = half > 0 ? 1 / half : 1;
    checker_scale_ = half > 0 ? look_.checker_cells / box.diagonal() : 1;
    for (const Vec<3>& origin : look_.origins)
      palette_.push_back(linear(position_color(origin_scale_ * (origin - origin_centre_))));
  } else if (look_.paint == Paint::scalar) {
    for (int i = 0; i <= n_shades; ++i)
      palette_.push_back(linear(map_color(look_.color_map, static_cast<double>(i) / n_shades)));
    palette_.push_back(linear(map_color(look_.color_map, std::numeric_limits<double>::quiet_NaN())));
  } else {
    palette_.push_back(linear(look_.color));
  }
}

std::vector<float> openness(const Surface<3>& s, const RayScene& scene, double reach) {
  const std::vector<Vec<3>> normals = vertex_normals(s);
  // The more vertices a pixel has, the fewer directions each needs: their mean is seen.
  const std::vector<Vec<3>> sky = sphere_directions(s.vertices.size() > 200000 ? 16
                                                    : s.vertices.size() > 4000 ? 64
                                                                               : 160);
  std::vector<float> raw(s.vertices.size(), 1);
  Activity shading("shading", raw.size());
  std::atomic<std::size_t> n_shaded = 0;
  parallel_for(
      raw.size(),
      [&](std::size_t i) {
        const Vec<3> start = s.vertices[i] + 2e-3 * reach * normals[i];
        double open = 0, all = 0;
        for (const Vec<3>& d : sky) {
          const double weight = d.dot(normals[i]);
          if (weight <= 0.05) continue;
          all += weight;
          if (!scene.is_blocked({start, d}, 0, reach)) open += weight;
        }
        raw[i] = all > 0 ? static_cast<float>(open / all) : 1;
        if (const std::size_t n = ++n_shaded; n % 4096 == 0) shading.done(n);
      },
      256);
  std::vector<float> smooth(raw.size(), 0);
  std::vector<int> count(raw.size(), 0);
  for (const auto& [a, b, c] : s.facets) {
    const float mean = (raw[a] + raw[b] + raw[c]) / 3;
    for (const Index v : {a, b, c}) {
      smooth[v] += mean;
      ++count[v];
    }
  }
  for (std::size_t i = 0; i < raw.size(); ++i) smooth[i] = count[i] > 0 ? smooth[i] / static_cast<float>(count[i]) : 1;
  return smooth;
}

Vec<3> PaintedSurface::normal(const Ray& ray, Index facet, double u, double v) const {
  const auto& n = normals_[facet];
  const Vec<3> sum = ((1 - u - v) * n[0] + u * n[1] + v * n[2]).normalized();
  return sum.dot(ray.direction) > 0 ? Vec<3>(-sum) : sum;  // both sides are lit
}

Vec<3> PaintedSurface::albedo(Index facet, double u, double v) const {
  const auto& corners = look_.surface->facets[facet];
  switch (look_.paint) {
    case Paint::uniform: break;
    case Paint::scalar: {
      const double value = interpolate(look_.scalars, corners, u, v);
      const double range = look_.scalar_max - look_.scalar_min;
      const double t = range > 0 ? (value - look_.scalar_min) / range : 0;
      if (std::isnan(t)) return palette_.back();
      return palette_[static_cast<std::size_t>(std::lround(std::clamp(t, 0.0, 1.0) * n_shades))];
    }
    case Paint::position:
    case Paint::checker: {
      const Vec<3> base = interpolate(palette_, corners, u, v);
      if (look_.paint == Paint::position) return base;
      const Vec<3> origin = interpolate(look_.origins, corners, u, v) - origin_centre_;
      // The checkerboard is rotated so that its planes do not coincide with flat sides of a shape.
      static const Mat<3> turn = Eigen::AngleAxisd(0.41, Vec<3>(0.3, 0.8, 0.52).normalized()).toRotationMatrix();
      const Vec<3> cell = checker_scale_ * (turn * origin);
      const long parity = static_cast<long>(std::floor(cell.x())) + static_cast<long>(std::floor(cell.y())) +
                          static_cast<long>(std::floor(cell.z()));
      return parity & 1 ? Vec<3>(0.5 * base) : Vec<3>(base + 0.12 * (Vec<3>::Ones() - base));
    }
  }
  return palette_[0];
}

Vec<3> PaintedSurface::light(const Camera& camera, const Ray& ray, Index facet, double u, double v) const {
  const Vec<3> world = normal(ray, facet, u, v);
  // Lights are fixed in the frame of the camera.
  const Vec<3> n(world.dot(camera.right), world.dot(camera.up), world.dot(camera.backward));
  static const Vec<3> key = Vec<3>(-0.50, 0.72, 0.75).normalized(), fill = Vec<3>(0.85, -0.05, 0.55).normalized();
  const double open = look_.openness.empty() ? 1 : interpolate(look_.openness, look_.surface->facets[facet], u, v);
  const double sky = 0.30 + 0.12 * n.y();
  // Occlusion attenuates the wide lights fully and the narrow key light in part.
  const double diffuse =
      open * sky + (0.4 + 0.6 * open) * 0.62 * std::max(0.0, n.dot(key)) + open * 0.16 * std::max(0.0, n.dot(fill));
  static const Vec<3> half = (key + Vec<3>::UnitZ()).normalized();
  const double gloss = 0.05 * open * highlight(std::max(0.0, n.dot(half)));
  return diffuse * albedo(facet, u, v) + Vec<3>::Constant(gloss);
}

double PaintedSurface::opacity(const Ray& ray, Index facet, double u, double v) const {
  if (look_.opacity >= 1) return 1;
  const double away = 1 - std::min(1.0, std::abs(normal(ray, facet, u, v).dot(ray.direction)));
  return look_.opacity + (1 - look_.opacity) * 0.8 * away * away * away;
}

}  // namespace shellmatch
