#pragma once
/// \file
/// A dolphin, straight at rest and bent by an explicit map of space. It swims towards -x, its back along +z.

#include "base/options.h"
#include "geometry/generate/body.h"

namespace shellmatch {

struct DolphinOptions {
  double bend = 0;
  double sway = 0;
  double turn = 0;
  double fatness = 1;
  static void describe(auto& self, auto& visit) {
    visit("bend", self.bend,
          {.unit = "degrees",
           .min = -70,
           .max = 70,
           .meaning = "turn of the tail against the head in the upright plane; positive: tail down"});
    visit("sway", self.sway,
          {.unit = "degrees", .min = -40, .max = 40, .meaning = "turn of the tail against the head sideways"});
    visit("turn", self.turn,
          {.unit = "degrees",
           .min = -180,
           .max = 180,
           .meaning = "turn of the whole dolphin about the upright axis through the domain's middle"});
    visit("fatness", self.fatness, {.min = 0.7, .max = 1.25, .meaning = "factor on the radii of the trunk"});
  }
};

/// Rest shape: the straight dolphin in the domain. The pose bends space along the spine. Cross sections
/// remain plane, undistorted and orthogonal to the spine, whose length is preserved. Dolphins of the same
/// fatness correspond.
Body<3> dolphin_body(const DolphinOptions& options, double edge_length);

}  // namespace shellmatch
