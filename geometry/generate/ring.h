#pragma once
/// \file
/// A bar with round ends, bent to a ring that is open, or whose ends press into each other.

#include "base/options.h"
#include "geometry/generate/body.h"

namespace shellmatch {

struct RingOptions {
  double arc = 280;
  double radius = 0.09;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("arc", self.arc,
          {.unit = "degrees",
           .min = 180,
           .max = 350,
           .meaning = "by which the bar's axis is bent, without its round ends; its length stays the same"});
    visit("radius", self.radius, {.unit = "side of the domain", .min = 0.04, .max = 0.12, .meaning = "of the bar"});
  }
};

/// Rest shape: the straight bar, half as large. The pose bends its axis to a part of a circle; cross sections remain
/// plane, undistorted and orthogonal to it. Where the ends meet, the surface crosses itself. Rings of the same radius
/// correspond.
Body<3> ring_body(const RingOptions& options, double edge_length);

}  // namespace shellmatch
