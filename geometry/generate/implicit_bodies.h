#pragma once
/// \file
/// Bodies that signed functions describe: box, ring, sugar beet and head.

#include "base/options.h"
#include "geometry/generate/body.h"

namespace shellmatch {

struct BoxOptions {
  double side_x = 0.45, side_y = 0.45, side_z = 0.45;
  double rounding = 0.05;
  double compression = 1;
  double turn = 0;
  int turn_axis = 3;
  static void describe(auto& self, auto& visit) {
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

struct RingOptions {
  double arc = 280;
  double radius = 0.09;
  static void describe(auto& self, auto& visit) {
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

struct BeetOptions {
  double width = 0.2;
  double bend = 0.03;
  double groove_depth = 0.022;
  double groove_turn = 60;
  double bumpiness = 0.006;
  int individual = 1;
  static void describe(auto& self, auto& visit) {
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

struct FaceOptions {
  double smile = 0;
  double nose = 1;
  double brow = 1;
  double jaw = 1;
  double width = 1;
  double ears = 1;
  static void describe(auto& self, auto& visit) {
    visit("smile", self.smile,
          {.min = 0, .max = 1, .meaning = "lift and width of the corners of the mouth, and cheeks"});
    visit("nose", self.nose, {.min = 0.6, .max = 1.5, .meaning = "factor on the size of the nose"});
    visit("brow", self.brow, {.min = 0.5, .max = 1.4, .meaning = "factor on the thickness of the brows"});
    visit("jaw", self.jaw, {.min = 0.8, .max = 1.2, .meaning = "factor on the width of the jaw"});
    visit("width", self.width, {.min = 0.85, .max = 1.15, .meaning = "factor on the width of the skull"});
    visit("ears", self.ears, {.min = 0.7, .max = 1.3, .meaning = "factor on the size of the ears"});
  }
};

/// Rest shape: the posed shape itself (the pose is the identity): faces do not correspond point by point.
Body<3> face_body(const FaceOptions& options, double edge_length);

}  // namespace shellmatch
