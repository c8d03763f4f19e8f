#include "geometry/generate/dolphin.h"

#include "geometry/implicit/mesh_implicit.h"

#include <algorithm>
#include <array>

namespace shellmatch {

namespace {

constexpr double spine_height = 0.48;

// Value at `t` in [0, 1] of the uniform cubic B-spline with these control values; its slope is 0 at both
// ends.
double spline(std::span<const double> control, double t) {
  const int n = static_cast<int>(control.size());
  const double place = std::clamp(t, 0.0, 1.0) * (n + 1);
  const int first = std::min(static_cast<int>(place), n);
  const double u = place - first, v = 1 - u;
  const auto at = [&](int i) { return control[std::clamp(i, 0, n - 1)]; };
  return (v * v * v * at(first - 2) + (4 + u * u * (3 * u - 6)) * at(first - 1) +
          (4 + v * v * (3 * v - 6)) * at(first) + u * u * u * at(first + 1)) /
         6;
}

// A tube about a curved axis; its radius and height are splines along the body, both ends are half balls.
double trunk(const Vec<3>& x, double fatness) {
  static constexpr double begin = 0.125, end = 0.85;
  static constexpr double radius[] = {0.015, 0.024, 0.058, 0.074, 0.084, 0.088, 0.087,
                                      0.081, 0.071, 0.057, 0.043, 0.031, 0.021, 0.018};
  static constexpr double height[] = {0.452, 0.460, 0.476, 0.482, 0.485, 0.486, 0.486,
                                      0.486, 0.485, 0.484, 0.482, 0.48,  0.48,  0.48};
  const double t = (x.x() - begin) / (end - begin);
  const double r = spline(radius, t), fat = r + (fatness - 1) * std::max(r - 0.025, 0.0);
  const Vec<3> axis(std::clamp(x.x(), begin, end), 0.5, spline(height, t));
  return 0.9 * ((x - axis).norm() - fat);
}

// Fins are swept-back plates: the coordinate along the body is sheared by the square of the distance from the
// root.
double swept_plate(double along, double out, double off, double sweep, const std::array<Vec<2>, 4>& outline) {
  return rounded_plate(Vec<3>(along - sweep * out * out, out, off), outline, 0.0015, 0.0095);
}

double dorsal_fin(const Vec<3>& x) {
  static const std::array<Vec<2>, 4> outline{Vec<2>(-0.065, -0.02), Vec<2>(0.05, -0.02), Vec<2>(0.035, 0.095),
                                             Vec<2>(0.02, 0.095)};
  return swept_plate(x.x() - 0.475, x.z() - 0.55, x.y() - 0.5, 4.5, outline);
}

double pectoral_fin(const Vec<3>& x, double side) {
  static const std::array<Vec<2>, 4> outline{Vec<2>(-0.035, -0.02), Vec<2>(0.04, -0.02), Vec<2>(0.022, 0.13),
                                             Vec<2>(0.008, 0.13)};
  // Out and down by 40 degrees.
  const double y = side * (x.y() - 0.5) - 0.045, z = x.z() - 0.44;
  const double c = std::cos(radians(40)), s = std::sin(radians(40));
  return swept_plate(x.x() - 0.325, c * y - s * z, s * y + c * z, 3.5, outline);
}

double fluke(const Vec<3>& x, double side) {
  static const std::array<Vec<2>, 4> outline{Vec<2>(-0.05, -0.012), Vec<2>(0.032, -0.012), Vec<2>(0.022, 0.135),
                                             Vec<2>(0.008, 0.135)};
  return swept_plate(x.x() - 0.83, side * (x.y() - 0.5), x.z() - 0.48, 1.8, outline);
}

double dolphin(const Vec<3>& x, double fatness) {
  double d = trunk(x, fatness);
  d = smooth_union(d, dorsal_fin(x), 0.03);
  for (const double side : {-1.0, 1.0}) d = smooth_union(d, pectoral_fin(x, side), 0.025);
  return smooth_union(d, smooth_union(fluke(x, 1), fluke(x, -1), 0.02), 0.03);
}

// The spine bends between 0.25 and 0.9; the angle grows like a smooth step with three continuous derivatives.
double turned_share(double along) {
  const double t = std::clamp((along - 0.25) / 0.65, 0.0, 1.0);
  return t * t * t * t * (35 + t * (-84 + t * (70 - 20 * t)));
}

Vec<3> spine_direction(double along, double bend, double sway) {
  const double share = turned_share(along), a = share * bend, b = share * sway;
  return {std::cos(a) * std::cos(b), std::cos(a) * std::sin(b), -std::sin(a)};
}

Vec<3> bent(const Vec<3>& x, double bend, double sway) {
  // Simpson's rule from 0.25, before which the spine is straight; the integrand is smooth.
  constexpr double start = 0.25;
  constexpr int n = 64;
  Vec<3> spine(start, 0.5, spine_height);
  const double length = x.x() - start, step = length / n;
  for (int i = 0; i <= n; ++i)
    spine += step / 3 * (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * spine_direction(start + i * step, bend, sway);
  // The frame: a rotation about the y axis, followed by one about the z axis.
  const double share = turned_share(x.x()), a = share * bend, b = share * sway;
  const Vec<3> across(-std::sin(b), std::cos(b), 0);
  const Vec<3> up(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
  // The head is rotated by half of the angle, so that the body remains in the middle of the domain.
  const Vec<3> y = spine + (x.y() - 0.5) * across + (x.z() - spine_height) * up;
  const Vec<3> pivot(0.5, 0.5, spine_height);
  const Mat<3> back =
      (Eigen::AngleAxisd(-0.4 * bend, Vec<3>::UnitY()) * Eigen::AngleAxisd(-0.4 * sway, Vec<3>::UnitZ()))
          .toRotationMatrix();
  return pivot + back * (y - pivot);
}

}  // namespace

Body<3> dolphin_body(const DolphinOptions& options, double edge_length) {
  const double bend = radians(options.bend), sway = radians(options.sway);
  const Mat<3> turn = Eigen::AngleAxisd(radians(options.turn), Vec<3>::UnitZ()).toRotationMatrix();
  return {mesh_implicit([&](const Vec<3>& x) { return dolphin(x, options.fatness); }, edge_length, "dolphin"),
          [bend, sway, turn](const Vec<3>& x) {
            const Vec<3> middle = Vec<3>::Constant(0.5);
            return Vec<3>(middle + turn * (bent(x, bend, sway) - middle));
          }};
}

}  // namespace shellmatch
