#include "geometry/generate/ring.h"

#include "geometry/implicit/mesh_implicit.h"

#include <algorithm>

namespace shellmatch {

namespace {

constexpr double length = 1.28;  // of the axis after posing
constexpr double scale = 2;      // of the pose

}  // namespace

Body<3> ring_body(const RingOptions& options, double edge_length) {
  const double half = 0.5 * length / scale;
  const Vec<3> centre = domain_centre<3>(), end(half, 0, 0);
  const RoundedCone bar(centre - end, centre + end, options.radius / scale, options.radius / scale);
  const double radius = length / radians(options.arc);  // of the axis
  return {mesh_implicit([bar](const Vec<3>& x) { return bar(x); }, edge_length / scale, "ring"),
          [=](const Vec<3>& x) -> Vec<3> {
            const Vec<3> d = scale * (x - centre);
            const double along = std::clamp(d.x(), -0.5 * length, 0.5 * length), beyond = d.x() - along,
                         angle = along / radius;
            const double out = radius - d.y();
            return centre + Vec<3>(out * std::cos(angle) - beyond * std::sin(angle),
                                   out * std::sin(angle) + beyond * std::cos(angle), d.z());
          }};
}

}  // namespace shellmatch
