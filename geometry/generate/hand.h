#pragma once
/// \file
/// A hand: palm, wrist and five fingers that rotate rigidly about their bases. The fingers point along y, the
/// thumb along -x, and the palm faces -z.

#include "base/options.h"
#include "geometry/generate/body.h"
#include "geometry/implicit/implicit_function.h"

#include <array>
#include <optional>
#include <vector>

namespace shellmatch {

struct HandOptions {
  double spread = 1;
  double bend_thumb = 0, bend_index = 0, bend_middle = 0, bend_ring = 0, bend_little = 0;
  static void describe(auto& self, auto& visit) {
    visit("spread", self.spread, {.min = 0.85, .max = 1.6, .meaning = "factor on the angles between the four fingers"});
    const auto bend = [&](const char* name, auto& value) {
      visit(
          name, value,
          {.unit = "degrees", .min = -20, .max = 60, .meaning = "turn of the finger about its base, towards the palm"});
    };
    bend("bend_thumb", self.bend_thumb);
    bend("bend_index", self.bend_index);
    bend("bend_middle", self.bend_middle);
    bend("bend_ring", self.bend_ring);
    bend("bend_little", self.bend_little);
  }
};

/// The signed functions of the parts of a hand, and of the whole.
class Hand {
 public:
  explicit Hand(const HandOptions& options);

  double operator()(const Vec<3>& x) const;

  /// The point of `other` that corresponds to the point x of this hand's surface. It is known if x belongs to
  /// one finger or to the palm alone, outside all blends, in both poses. \pre both hands have the same spread
  std::optional<Vec<3>> corresponding_point(const Hand& other, const Vec<3>& x) const;

  /// The finger (0 thumb to 4 little finger) that alone forms the surface near x; 5 for palm and wrist; -1
  /// for blends.
  int part_of(const Vec<3>& x) const;

 private:
  struct Finger {
    Vec<3> base;      // centre of the rotation
    Mat<3> rotation;  // from the finger's axes (y along it) to those of the domain
    double length, thickness;
    RoundedCone lower, upper;  // in the finger's axes
  };
  double finger(int k, const Vec<3>& x) const;
  double palm(const Vec<3>& x) const;
  // Lower bounds, which cost little.
  double finger_at_least(int k, const Vec<3>& x) const;
  double palm_at_least(const Vec<3>& x) const;
  // The union of the fingers, given their lower bounds.
  double fingers(const Vec<3>& x, const std::array<double, 5>& at_least) const;

  std::vector<Finger> fingers_;
};

/// Rest shape: the posed shape itself. Hand::corresponding_point() defines the correspondence.
Body<3> hand_body(const HandOptions& options, double edge_length);

}  // namespace shellmatch
