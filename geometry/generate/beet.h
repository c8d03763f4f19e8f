#pragma once
/// \file
/// A sugar beet: a conical root with a crown, two spiralling grooves and an uneven skin.

#include "base/options.h"
#include "geometry/generate/body.h"

namespace shellmatch {

struct BeetOptions {
  double width = 0.2;
  double bend = 0.03;
  double groove_depth = 0.022;
  double groove_turn = 60;
  double bumpiness = 0.006;
  int individual = 1;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("width", self.width, {.unit = "side of the domain", .min = 0.1, .max = 0.28, .meaning = "greatest radius"});
    visit(
        "bend", self.bend,
        {.unit = "side of the domain", .min = -0.1, .max = 0.1, .meaning = "sideways shift of the middle of the root"});
    visit("groove_depth", self.groove_depth,
          {.unit = "side of the domain", .min = 0, .max = 0.03, .meaning = "depth of the two grooves"});
    visit("groove_turn", self.groove_turn,
          {.unit = "degrees",
           .min = -180,
           .max = 180,
           .meaning = "turn of the grooves about the axis from crown to tip"});
    visit("bumpiness", self.bumpiness,
          {.unit = "side of the domain",
           .min = 0,
           .max = 0.01,
           .meaning = "root of the mean square of the skin's height"});
    visit("individual", self.individual, {.min = 1, .max = 1000, .meaning = "which of the random skins"});
  }
};

/// Rest shape: the posed shape itself (the pose is the identity): individuals do not correspond point by
/// point.
Body<3> beet_body(const BeetOptions& options, double edge_length);

}  // namespace shellmatch
