#include "geometry/generate/beet.h"

#include "geometry/implicit/mesh_implicit.h"

#include <random>

namespace shellmatch {

namespace {

struct Wave {
  Vec<3> direction;  // radians per unit of length
  double phase;
};

// Sixteen plane waves of random direction and of 2 to 6 periods per side of the domain. The language standard
// fixes the raw output of the random generator, so the result is the same on every machine.
std::vector<Wave> skin_waves(int individual) {
  std::mt19937 generator(static_cast<std::uint32_t>(individual));
  const auto uniform = [&](double min, double max) { return min + (max - min) * (generator() / 4294967296.0); };
  std::vector<Wave> waves(16);
  for (Wave& w : waves) {
    const double up = uniform(-1, 1), around = uniform(0, 2 * M_PI), periods = uniform(2, 6);
    const double level = std::sqrt(1 - up * up);
    w.direction = 2 * M_PI * periods * Vec<3>(level * std::cos(around), level * std::sin(around), up);
    w.phase = uniform(0, 2 * M_PI);
  }
  return waves;
}

}  // namespace

Body<3> beet_body(const BeetOptions& options, double edge_length) {
  const std::vector<Wave> waves = skin_waves(options.individual);
  const double r = options.width, bottom = 0.13, top = 0.86;
  const auto beet = [&](const Vec<3>& y) {
    // Height runs along z; a smooth sideways shift bends the axis.
    const double height = (y.z() - bottom) / (top - bottom);
    const Vec<3> x(y.x() - 0.5 - options.bend * std::sin(M_PI * height), y.y() - 0.5, y.z());
    const auto at = [](double z) { return Vec<3>(0, 0, z); };
    double d = rounded_cone(x, at(0.8 - r), at(0.34), r, 0.42 * r);
    d = smooth_union(d, rounded_cone(x, at(0.34), at(bottom), 0.42 * r, 0.016), 0.08);
    d = smooth_union(d, rounded_cone(x, at(0.76 - 0.4 * r), at(top - 0.3 * r), 0.42 * r, 0.3 * r), 0.05);
    // The two grooves lie where the rotated cross coordinate vanishes; they fade out towards axis, crown and
    // tip.
    const double angle = radians(options.groove_turn) * height;
    const double across = std::cos(angle) * x.x() + std::sin(angle) * x.y();
    const double rho = std::hypot(x.x(), x.y()), width = 0.22 * (rho + 0.02);
    const double fade = std::exp(-std::pow((height - 0.45) / 0.28, 4)) * rho * rho / (rho * rho + 0.03 * 0.03);
    d += options.groove_depth * fade * std::exp(-across * across / (width * width));
    double skin = 0;
    for (const Wave& w : waves) skin += std::sin(w.direction.dot(x) + w.phase);
    // The mean square of a sum of n sines is n/2. The tip is too thin for bumps.
    const double thick = std::min(std::max(height / 0.25, 0.0), 1.0);
    return d + options.bumpiness * std::sqrt(2.0 / waves.size()) * thick * thick * (3 - 2 * thick) * skin;
  };
  return {mesh_implicit(beet, edge_length, "beet"), [](const Vec<3>& x) { return x; }};
}

}  // namespace shellmatch
