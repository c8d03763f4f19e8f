#include "geometry/generate/implicit_bodies.h"

#include "base/error.h"
#include "geometry/implicit/mesh_implicit.h"

#include <algorithm>
#include <random>

namespace shellmatch {

Body<3> box_body(const BoxOptions& options, double edge_length) {
  const Vec<3> half_sides = 0.5 * Vec<3>(options.side_x, options.side_y, options.side_z);
  if (options.rounding > half_sides.minCoeff())
    throw_input_error("box: rounding {:g} exceeds half the shortest side, {:g}; choose a smaller one", options.rounding,
                      half_sides.minCoeff());
  Body<3> body;
  body.rest =
      mesh_implicit([&](const Vec<3>& x) { return rounded_box(x - domain_centre<3>(), half_sides, options.rounding); },
                    edge_length, "box");
  for (Vec<3>& x : body.rest.vertices) x -= domain_centre<3>();
  const Mat<3> turn = Eigen::AngleAxisd(radians(options.turn), Vec<3>::Unit(options.turn_axis - 1)).toRotationMatrix();
  const Mat<3> linear = turn * Vec<3>(options.compression, 1, 1).asDiagonal();
  body.pose = [linear](const Vec<3>& x) -> Vec<3> { return domain_centre<3>() + linear * x; };
  return body;
}

namespace {

constexpr double ring_length = 1.28;  // of the axis after posing
constexpr double ring_scale = 2;      // of the pose

}  // namespace

Body<3> ring_body(const RingOptions& options, double edge_length) {
  const double half = 0.5 * ring_length / ring_scale;
  const Vec<3> centre = domain_centre<3>(), end(half, 0, 0);
  const RoundedCone bar(centre - end, centre + end, options.radius / ring_scale, options.radius / ring_scale);
  const double radius = ring_length / radians(options.arc);  // of the axis
  return {mesh_implicit([bar](const Vec<3>& x) { return bar(x); }, edge_length / ring_scale, "ring"),
          [=](const Vec<3>& x) -> Vec<3> {
            const Vec<3> d = ring_scale * (x - centre);
            const double along = std::clamp(d.x(), -0.5 * ring_length, 0.5 * ring_length), beyond = d.x() - along,
                         angle = along / radius;
            const double out = radius - d.y();
            return centre + Vec<3>(out * std::cos(angle) - beyond * std::sin(angle),
                                   out * std::sin(angle) + beyond * std::cos(angle), d.z());
          }};
}

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

namespace {

double ball(const Vec<3>& x, double px, double py, double pz, double radius) {
  return (x - Vec<3>(px, py, pz)).norm() - radius;
}

// A smoothed absolute value of x makes the face symmetric without a crease in the plane of symmetry.
double face(const Vec<3>& y, const FaceOptions& o) {
  const Vec<3> x(std::sqrt((y.x() - 0.5) * (y.x() - 0.5) + 1e-4) - 0.005, y.y(), y.z());
  const double smile = o.smile;
  double d = ellipsoid_function(x - Vec<3>(0, 0.6, 0.45), Vec<3>(0.205 * o.width, 0.235, 0.25));
  d = smooth_union(d, ellipsoid_function(x - Vec<3>(0, 0.44, 0.53), Vec<3>(0.142 * o.jaw, 0.17, 0.155)), 0.09);
  d = smooth_union(d, rounded_cone(x, Vec<3>(0, 0.2, 0.40), Vec<3>(0, 0.42, 0.43), 0.1, 0.092), 0.06);
  // Eye sockets, eyeballs, brows.
  d = smooth_difference(d, ball(x, 0.078, 0.567, 0.722, 0.046), 0.05);
  d = smooth_union(d, ball(x, 0.077, 0.565, 0.64, 0.034), 0.012);
  d = smooth_union(
      d, rounded_cone(x, Vec<3>(0.03, 0.612, 0.668), Vec<3>(0.115, 0.622, 0.632), 0.02 * o.brow, 0.014 * o.brow), 0.03);
  // Nose: bridge, tip, wings.
  const double n = o.nose;
  d = smooth_union(
      d, rounded_cone(x, Vec<3>(0, 0.585, 0.672), Vec<3>(0, 0.492, 0.688 + 0.042 * n), 0.015 * n, 0.023 * n), 0.03);
  d = smooth_union(d, ball(x, 0.022 * n, 0.487, 0.68 + 0.018 * n, 0.019 * n), 0.025);
  // Cheeks, chin, lips. A smile lifts and widens the corners of the mouth and fills the cheeks.
  d = smooth_union(d, ball(x, 0.098, 0.49 + 0.015 * smile, 0.605 + 0.008 * smile, 0.048 + 0.007 * smile), 0.06);
  d = smooth_union(d, ball(x, 0, 0.318, 0.642, 0.036), 0.05);
  const Vec<3> corner(0.05 + 0.03 * smile, 0.401 + 0.042 * smile, 0.66 - 0.002 * smile);
  const auto lip = [&](double height, double forward, double thickness) {
    const Vec<3> middle(0, height - 0.004 * smile, forward);
    const Vec<3> between(0.026 + 0.014 * smile, height + 0.006 * smile, forward - 0.005);
    return smooth_union(rounded_cone(x, middle, between, thickness, 0.95 * thickness),
                        rounded_cone(x, between, corner, 0.95 * thickness, 0.45 * thickness), 0.01);
  };
  d = smooth_union(d, smooth_union(lip(0.417, 0.674, 0.016), lip(0.384, 0.669, 0.017), 0.012), 0.025);
  // Ears: tilted flat ellipsoids with a hollow.
  const Vec<3> ear = Eigen::AngleAxisd(radians(20), Vec<3>::UnitY()) * (x - Vec<3>(0.2 * o.width, 0.545, 0.455));
  d = smooth_union(d, ellipsoid_function(ear, o.ears * Vec<3>(0.03, 0.062, 0.044)), 0.03);
  return smooth_difference(
      d, ellipsoid_function(ear - Vec<3>(0.036, 0.006, 0.01), o.ears * Vec<3>(0.016, 0.034, 0.022)), 0.02);
}

}  // namespace

Body<3> face_body(const FaceOptions& options, double edge_length) {
  return {mesh_implicit([&](const Vec<3>& x) { return face(x, options); }, edge_length, "face"),
          [](const Vec<3>& x) { return x; }};
}

}  // namespace shellmatch
