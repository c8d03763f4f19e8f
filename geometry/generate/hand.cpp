#include "geometry/generate/hand.h"

#include "geometry/implicit/mesh_implicit.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

constexpr double finger_blend = 0.02, palm_blend = 0.045;
// Translation of the anatomy below into the middle of the domain.
const Vec<3> anatomy_offset(0.052, 0.045, 0);

}  // namespace

Hand::Hand(const HandOptions& options) {
  struct Anatomy {
    Vec<3> base;
    double angle;  // from y towards +x, degrees
    double length, thickness, bend;
  };
  const Anatomy anatomy[5] = {{{0.402, 0.315, 0.5}, -52, 0.215, 0.037, options.bend_thumb},
                              {{0.402, 0.475, 0.5}, -12 * options.spread, 0.265, 0.0285, options.bend_index},
                              {{0.470, 0.490, 0.5}, -2.5 * options.spread, 0.300, 0.030, options.bend_middle},
                              {{0.537, 0.482, 0.5}, 7 * options.spread, 0.275, 0.0285, options.bend_ring},
                              {{0.598, 0.455, 0.5}, 18 * options.spread, 0.215, 0.025, options.bend_little}};
  for (int k = 0; k < 5; ++k) {
    const Anatomy& a = anatomy[k];
    const Mat<3> direction = Eigen::AngleAxisd(radians(-a.angle), Vec<3>::UnitZ()).toRotationMatrix();
    // A rotation about -x moves y towards -z. The thumb is rotated by 12 degrees at rest.
    const double turn = radians(a.bend + (k == 0 ? 12 : 0));
    fingers_[k] = {a.base + anatomy_offset,
                   direction * Eigen::AngleAxisd(turn, -Vec<3>::UnitX()).toRotationMatrix(), a.length,
                   a.thickness};
  }
}

double Hand::finger(int k, const Vec<3>& x) const {
  const Finger& f = fingers_[k];
  const Vec<3> y = f.rotation.transpose() * (x - f.base);
  const double r = f.thickness, end = f.length - 0.75 * r, knuckle = (k == 0 ? 0.62 : 0.5) * f.length;
  const auto at = [](double along) { return Vec<3>(0, along, 0); };
  const double lower = rounded_cone(y, at(0), at(knuckle), r, 0.88 * r);
  const double upper = rounded_cone(y, at(knuckle), at(end), 0.92 * r, 0.74 * r);
  return smooth_union(lower, upper, 0.02);
}

double Hand::palm(const Vec<3>& point) const {
  const Vec<3> x = point - anatomy_offset;
  // Four bones from the wrist to the knuckles and the ball of the thumb, flattened, and the stump of the arm.
  constexpr double flatness = 0.78;
  const auto flat = [&](const Vec<3>& a, const Vec<3>& b, double ra, double rb) {
    const auto stretch = [&](const Vec<3>& p) {
      return Vec<3>(p.x(), p.y(), 0.5 + (p.z() - 0.5) / flatness);
    };
    return flatness * rounded_cone(stretch(x), a, b, ra, rb);
  };
  const Vec<3> wrist(0.5, 0.25, 0.5);
  double d = flat(Vec<3>(0.47, 0.25, 0.5), Vec<3>(0.410, 0.455, 0.5), 0.052, 0.045);
  d = smooth_union(d, flat(wrist, Vec<3>(0.470, 0.470, 0.5), 0.052, 0.046), 0.04);
  d = smooth_union(d, flat(wrist, Vec<3>(0.534, 0.462, 0.5), 0.052, 0.045), 0.04);
  d = smooth_union(d, flat(Vec<3>(0.53, 0.25, 0.5), Vec<3>(0.585, 0.435, 0.5), 0.050, 0.041), 0.04);
  d = smooth_union(d, rounded_cone(x, Vec<3>(0.475, 0.26, 0.485), Vec<3>(0.42, 0.32, 0.48), 0.045, 0.042),
                   0.05);
  return smooth_union(d, flat(Vec<3>(0.5, 0.18, 0.5), Vec<3>(0.5, 0.28, 0.5), 0.066, 0.062), 0.05);
}

double Hand::operator()(const Vec<3>& x) const {
  double fingers = finger(0, x);
  for (int k = 1; k < 5; ++k) fingers = smooth_union(fingers, finger(k, x), finger_blend);
  return smooth_union(palm(x), fingers, palm_blend);
}

int Hand::part_of(const Vec<3>& x) const {
  std::array<double, 5> d;
  for (int k = 0; k < 5; ++k) d[k] = finger(k, x);
  const double p = palm(x);
  const int first = static_cast<int>(std::min_element(d.begin(), d.end()) - d.begin());
  // The smooth union of parts that differ by more than the width equals the smaller one.
  if (d[first] - p > palm_blend + finger_blend) return 5;
  for (int k = 0; k < 5; ++k)
    if (k != first && d[k] - d[first] < 2 * finger_blend) return -1;
  return p - d[first] > palm_blend ? first : -1;
}

std::optional<Vec<3>> Hand::corresponding_point(const Hand& other, const Vec<3>& x) const {
  const int part = part_of(x);
  if (part < 0) return std::nullopt;
  if (part == 5) return other.part_of(x) == 5 ? std::optional(x) : std::nullopt;
  const Finger &from = fingers_[part], &to = other.fingers_[part];
  const Vec<3> y = to.base + to.rotation * (from.rotation.transpose() * (x - from.base));
  return other.part_of(y) == part ? std::optional(y) : std::nullopt;
}

Body<3> hand_body(const HandOptions& options, double edge_length) {
  return {mesh_implicit(Hand(options), edge_length, "hand"), [](const Vec<3>& x) { return x; }};
}

}  // namespace shellmatch
