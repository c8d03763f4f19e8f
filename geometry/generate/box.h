#pragma once
/// \file
/// A box with rounded edges, compressed along x and rotated: the paper's cubes.

#include "base/options.h"
#include "geometry/generate/body.h"

namespace shellmatch {

struct BoxOptions {
  double side_x = 0.45, side_y = 0.45, side_z = 0.45;
  double rounding = 0.05;
  double compression = 1;
  double turn = 0;
  int turn_axis = 3;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("side_x", self.side_x, {.unit = "side of the domain", .min = 0.05, .max = 0.8, .meaning = "side along x"});
    visit("side_y", self.side_y, {.unit = "side of the domain", .min = 0.05, .max = 0.8, .meaning = "side along y"});
    visit("side_z", self.side_z, {.unit = "side of the domain", .min = 0.05, .max = 0.8, .meaning = "side along z"});
    visit("rounding", self.rounding,
          {.unit = "side of the domain",
           .min = 0.01,
           .max = 0.4,
           .meaning = "radius of edges and corners; at most half the shortest side"});
    visit("compression", self.compression, {.min = 0.3, .max = 1, .meaning = "factor on all lengths along x"});
    visit("turn", self.turn,
          {.unit = "degrees", .min = -180, .max = 180, .meaning = "rotation about turn_axis, after the compression"});
    visit("turn_axis", self.turn_axis, {.min = 1, .max = 3, .meaning = "axis of the turn: 1 = x, 2 = y, 3 = z"});
  }
};

/// Rest shape: the rounded box about 0. The pose compresses it, rotates it and moves it to the centre of the
/// domain.
/// \throws InputError where rounding exceeds half the shortest side.
Body<3> box_body(const BoxOptions& options, double edge_length);

}  // namespace shellmatch
