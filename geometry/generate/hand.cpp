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
  PalmBone(const Vec<3>& a, const Vec<3>& b, double ra, double rb, bool is_flat, double width)
      : cone(a, b, ra, rb), flat(is_flat), blend(width) {
    for (const auto& [centre, radius] : {std::pair(a, ra), std::pair(b, rb)}) {
      box.add(centre.head<2>() + Vec<2>::Constant(radius));
      box.add(centre.head<2>() - Vec<2>::Constant(radius));
    }
  }
  RoundedCone cone;
  Box<2> box;  // from the front
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
    const double r = a.thickness, end = a.length - 0.75 * r, knuckle = (k == 0 ? 0.62 : 0.5) * a.length;
    const auto at = [](double along) { return Vec<3>(0, along, 0); };
    fingers_.push_back(
        {a.base + anatomy_offset, direction * Eigen::AngleAxisd(turn, -Vec<3>::UnitX()).toRotationMatrix(), a.length, r,
         RoundedCone(at(0), at(knuckle), r, 0.88 * r), RoundedCone(at(knuckle), at(end), 0.92 * r, 0.74 * r)});
  }
}

double Hand::finger(int k, const Vec<3>& x) const {
  const Finger& f = fingers_[k];
  const Vec<3> y = f.rotation.transpose() * (x - f.base);
  return smooth_union(f.lower(y), f.upper(y), finger_blend);
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
    const double other = bone.flat ? flatness * bone.cone(stretched) : bone.cone(x);
    d = &bone == palm_bones ? other : smooth_union(d, other, bone.blend);
  }
  return d;
}

// As for a finger, with the box of all bones. A stretched distance is at least `flatness` times it, and each blend
// lowers the union by a sixth of its width at most.
double Hand::palm_at_least(const Vec<3>& point) const {
  static const auto [box, lowered] = [] {
    std::pair<Box<2>, double> all{{}, 0};
    for (const PalmBone& bone : palm_bones) {
      all.first.add(bone.box.min);
      all.first.add(bone.box.max);
      all.second += bone.blend / 6;
    }
    return all;
  }();
  const Vec<2> x = (point - anatomy_offset).head<2>();
  const double beyond = std::max((x - box.max).maxCoeff(), (box.min - x).maxCoeff());
  return std::min(beyond, flatness * beyond) - lowered;
}

double Hand::fingers(const Vec<3>& x, const std::array<double, 5>& at_least) const {
  const int nearest = static_cast<int>(std::min_element(at_least.begin(), at_least.end()) - at_least.begin());
  const double least = finger(nearest, x);
  double d = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 5; ++k) {
    if (at_least[k] > (k > nearest ? d : least + 1.5 * finger_blend) + finger_blend) continue;
    const double other = k == nearest ? least : finger(k, x);
    d = std::isinf(d) ? other : smooth_union(d, other, finger_blend);
  }
  return d;
}

// Parts too far to change the union are left out; it stays the same to the bit. Of two values that differ by more than
// the width smooth_union() returns the smaller, and it lowers none by more than a sixth of the width. A finger before
// the nearest one that is 2.5 widths above it changes nothing nearer to it than 2.5 - 1 - 1/6 widths, of which nothing
// is left once the nearest is added.
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
