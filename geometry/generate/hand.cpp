#include "geometry/generate/hand.h"

#include "geometry/implicit/mesh_implicit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

constexpr double finger_blend = 0.02, palm_blend = 0.045;
// Translation of the anatomy below into the middle of the domain.
const Vec<3> anatomy_offset(0.052, 0.045, 0);

// Four bones from the wrist to the knuckles, the ball of the thumb, and the stump of the arm. The flat ones are
// computed in a space whose z is divided by `flatness`.
constexpr double flatness = 0.78;
struct PalmBone {
  Vec<3> a, b;
  double ra, rb;
  bool flat;
  double blend;  // width of the union with the bones before it
};
const PalmBone palm_bones[] = {{{0.47, 0.25, 0.5}, {0.410, 0.455, 0.5}, 0.052, 0.045, true, 0},
                               {{0.5, 0.25, 0.5}, {0.470, 0.470, 0.5}, 0.052, 0.046, true, 0.04},
                               {{0.5, 0.25, 0.5}, {0.534, 0.462, 0.5}, 0.052, 0.045, true, 0.04},
                               {{0.53, 0.25, 0.5}, {0.585, 0.435, 0.5}, 0.050, 0.041, true, 0.04},
                               {{0.475, 0.26, 0.485}, {0.42, 0.32, 0.48}, 0.045, 0.042, false, 0.05},
                               {{0.5, 0.18, 0.5}, {0.5, 0.28, 0.5}, 0.066, 0.062, true, 0.05}};

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
  return smooth_union(lower, upper, finger_blend);
}

// The distance to a point of the axis is at least its largest component, less the greatest radius.
double Hand::finger_at_least(int k, const Vec<3>& x) const {
  const Finger& f = fingers_[k];
  const Vec<3> y = f.rotation.transpose() * (x - f.base);
  const double beyond = std::max({std::abs(y.x()), std::abs(y.z()), -y.y(), y.y() - f.length});
  return beyond - f.thickness - finger_blend / 6;
}

double Hand::palm(const Vec<3>& point) const {
  const Vec<3> x = point - anatomy_offset, stretched(x.x(), x.y(), 0.5 + (x.z() - 0.5) / flatness);
  double d = 0;
  for (const PalmBone& bone : palm_bones) {
    const double other = bone.flat ? flatness * rounded_cone(stretched, bone.a, bone.b, bone.ra, bone.rb)
                                   : rounded_cone(x, bone.a, bone.b, bone.ra, bone.rb);
    d = &bone == palm_bones ? other : smooth_union(d, other, bone.blend);
  }
  return d;
}

// As for a finger, with the box of all bones; a stretched distance is at least `flatness` times it.
double Hand::palm_at_least(const Vec<3>& point) const {
  static const Box<2> box = [] {
    Box<2> all;
    for (const PalmBone& bone : palm_bones)
      for (const auto& [centre, radius] : {std::pair(bone.a, bone.ra), std::pair(bone.b, bone.rb)}) {
        all.add(centre.head<2>() + Vec<2>::Constant(radius));
        all.add(centre.head<2>() - Vec<2>::Constant(radius));
      }
    return all;
  }();
  const Vec<2> x = (point - anatomy_offset).head<2>();
  const double beyond = std::max((x - box.max).maxCoeff(), (box.min - x).maxCoeff());
  double lowered = 0;
  for (const PalmBone& bone : palm_bones) lowered += bone.blend / 6;
  return std::min(beyond, flatness * beyond) - lowered;
}

double Hand::fingers(const Vec<3>& x, const std::array<double, 5>& at_least) const {
  const int nearest = static_cast<int>(std::min_element(at_least.begin(), at_least.end()) - at_least.begin());
  const double least = finger(nearest, x);
  double d = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 5; ++k) {
    if (at_least[k] > least + 3 * finger_blend) continue;
    const double other = k == nearest ? least : finger(k, x);
    d = std::isinf(d) ? other : smooth_union(d, other, finger_blend);
  }
  return d;
}

// Parts too far to change the union are left out; it stays the same to the bit. Of two values that differ by more
// than the width smooth_union() returns the smaller, and it lowers none by more than a sixth of the width: with three
// widths between a finger and the nearest, what it changes before the nearest is added is above that by a width.
double Hand::operator()(const Vec<3>& x) const {
  std::array<double, 5> at_least;
  for (int k = 0; k < 5; ++k) at_least[k] = finger_at_least(k, x);
  const double fingers_at_least = *std::min_element(at_least.begin(), at_least.end()) - 4 * finger_blend / 6;
  const double palm_is_at_least = palm_at_least(x);
  if (palm_is_at_least < fingers_at_least) {
    const double p = palm(x);
    return fingers_at_least > p + palm_blend ? p : smooth_union(p, fingers(x, at_least), palm_blend);
  }
  const double f = fingers(x, at_least);
  return palm_is_at_least > f + palm_blend ? f : smooth_union(palm(x), f, palm_blend);
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
