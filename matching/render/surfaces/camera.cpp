#include "matching/render/surfaces/camera.h"

#include "base/error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace shellmatch {

namespace {

// Axes of a camera at this azimuth and elevation (degrees). Azimuth 0 is the front: the direction +z, or -y
// if `up` is +z, orthogonalised against `up`.
Camera looking_from(double azimuth, double elevation, const Vec<3>& up_axis) {
  const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
  const Vec<3> up = up_axis.normalized();
  const Vec<3> wish = std::abs(up.z()) > 0.9 ? Vec<3>(-Vec<3>::UnitY()) : Vec<3>(Vec<3>::UnitZ());
  const Vec<3> front = (wish - wish.dot(up) * up).normalized(), side = up.cross(front);
  Camera camera;
  camera.backward = std::cos(e) * (std::cos(a) * front + std::sin(a) * side) + std::sin(e) * up;
  camera.right = std::cos(a) * side - std::sin(a) * front;
  camera.up = camera.backward.cross(camera.right);
  return camera;
}

// Sum of the projected areas of all facets along the viewing direction: a measure of how much is visible.
double projected_area(std::span<const Surface<3>* const> surfaces, const Vec<3>& direction) {
  double area = 0;
  for (const Surface<3>* s : surfaces)
    for (const auto& [a, b, c] : s->facets)
      area += 0.25 * std::abs((s->vertices[b] - s->vertices[a]).cross(s->vertices[c] - s->vertices[a]).dot(direction));
  return area;
}

Camera choose_view(std::span<const Surface<3>* const> surfaces, const ViewOptions& options) {
  const std::vector<double> azimuths =
      options.azimuth ? std::vector{*options.azimuth} : std::vector<double>{30, -30, 60, -60};
  const std::vector<double> elevations =
      options.elevation ? std::vector{*options.elevation} : std::vector<double>{18, 50};
  // Scans have their long axis along z, which +y as the upward direction would show end on.
  const std::vector<Vec<3>> ups =
      options.up ? std::vector{*options.up} : std::vector<Vec<3>>{Vec<3>::UnitY(), Vec<3>::UnitZ()};
  Camera best;
  double best_score = -1;
  for (std::size_t u = 0; u < ups.size(); ++u)
    for (const double e : elevations)
      for (const double a : azimuths) {
        const Camera camera = looking_from(a, e, ups[u]);
        // Prefers +y upwards, views from the front and from a low elevation unless another one shows clearly more.
        const double habit =
            (std::abs(a) > 45 ? 0.85 : 1.0) * (e > 30 ? 0.7 : 1.0) * (a < 0 ? 0.97 : 1.0) * (u > 0 ? 0.8 : 1.0);
        const double score = habit * projected_area(surfaces, camera.backward);
        if (score > best_score) {
          best_score = score;
          best = camera;
        }
      }
  return best;
}

}  // namespace

Ray camera_ray(const Camera& camera, double x, double y, double clearance) {
  const Vec<3> through = camera.target + camera.half_height * (x * camera.right + y * camera.up);
  if (camera.distance == 0) return {through + clearance * camera.backward, -camera.backward};
  const Vec<3> eye = camera.target + camera.distance * camera.backward;
  return {eye, (through - eye).normalized()};
}

Camera fit_camera(std::span<const Surface<3>* const> surfaces, double aspect, const ViewOptions& options) {
  Box<3> box;
  for (const Surface<3>* s : surfaces)
    for (const Vec<3>& v : s->vertices) box.add(v);
  SHELLMATCH_CHECK(box.diagonal() >= 0 && std::isfinite(box.diagonal()), "a camera needs finite points to look at");
  const double size = std::max(box.diagonal(), 1e-12);

  Camera camera = choose_view(surfaces, options);
  camera.target = 0.5 * (box.min + box.max);
  const double free = 1 - 2 * options.margin;
  const double slope = std::tan(0.5 * options.field_of_view * std::numbers::pi / 180);

  // Centring moves the eye and so changes the perspective: a fixed-point iteration.
  for (int round = 0; round < 8; ++round) {
    Box<2> seen;
    double reach = 0, nearest = 0;
    const double distance = camera.distance;
    for (const Surface<3>* s : surfaces)
      for (const Vec<3>& v : s->vertices) {
        const Vec<3> d = v - camera.target;
        const double depth = d.dot(camera.backward);
        nearest = std::max(nearest, depth);
        const double shrink = distance > 0 ? distance / (distance - depth) : 1;
        const Vec<2> p = shrink * Vec<2>(d.dot(camera.right), d.dot(camera.up));
        seen.add(p);
        const double half = std::max(std::abs(d.dot(camera.right)) / aspect, std::abs(d.dot(camera.up))) / free;
        reach = std::max(reach, slope > 0 ? half / slope + depth : half);
      }
    camera.distance = slope > 0 ? std::max(reach, nearest + 0.05 * size) : 0;
    camera.half_height = slope > 0 ? camera.distance * slope : reach;
    if (round == 7) break;
    const Vec<2> centre = 0.5 * (seen.min + seen.max);
    camera.target += centre.x() * camera.right + centre.y() * camera.up;
  }
  camera.half_height = std::max(camera.half_height, 1e-12);
  return camera;
}

}  // namespace shellmatch
