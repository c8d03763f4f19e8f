#pragma once
/// \file
/// Closed outlines of the plane. All are star-shaped about a centre and therefore free of self-intersections.

#include "base/options.h"
#include "geometry/generate/body.h"

namespace shellmatch {

struct CircleOptions {
  double radius = 0.3;
  static void describe(auto& self, auto& visit) {
    visit("radius", self.radius, {.unit = "side of the domain", .min = 0.02, .max = 0.4, .meaning = "radius"});
  }
};

struct EllipseOptions {
  double semi_x = 0.37, semi_y = 0.2;
  double turn = 0;
  static void describe(auto& self, auto& visit) {
    visit("semi_x", self.semi_x,
          {.unit = "side of the domain", .min = 0.02, .max = 0.4, .meaning = "semi-axis along x"});
    visit("semi_y", self.semi_y,
          {.unit = "side of the domain", .min = 0.02, .max = 0.4, .meaning = "semi-axis along y"});
    visit("turn", self.turn, {.unit = "degrees", .min = -180, .max = 180, .meaning = "rotation about the centre"});
  }
};

struct StarOptions {
  double radius = 0.28, depth = 0.28, turn = 0;
  int points = 5;
  static void describe(auto& self, auto& visit) {
    visit("radius", self.radius, {.unit = "side of the domain", .min = 0.05, .max = 0.35, .meaning = "mean radius"});
    visit("depth", self.depth, {.min = 0, .max = 0.6, .meaning = "deviation from the mean radius, as a share of it"});
    visit("points", self.points, {.min = 2, .max = 12, .meaning = "number of rounded points"});
    visit("turn", self.turn, {.unit = "degrees", .min = -180, .max = 180, .meaning = "rotation about the centre"});
  }
};

struct BlobOptions {
  double radius = 0.27, roughness = 0.1;
  int individual = 1;
  static void describe(auto& self, auto& visit) {
    visit("radius", self.radius, {.unit = "side of the domain", .min = 0.05, .max = 0.32, .meaning = "mean radius"});
    visit("roughness", self.roughness,
          {.min = 0, .max = 0.15, .meaning = "root of the mean square of the relative deviation from the radius"});
    visit("individual", self.individual, {.min = 1, .max = 1000, .meaning = "which of the random outlines"});
  }
};

struct LeafOptions {
  int lobes = 5;
  double depth = 0.5;
  double serration = 0.025;
  int teeth = 37;
  double asymmetry = 0.04;
  double slenderness = 1;
  double bend = 0;
  static void describe(auto& self, auto& visit) {
    visit("lobes", self.lobes, {.min = 3, .max = 9, .meaning = "number of lobes, odd for one in the middle"});
    visit("depth", self.depth,
          {.min = 0, .max = 0.7, .meaning = "depth of the bays between lobes, as a share of the leaf"});
    visit("serration", self.serration,
          {.min = 0, .max = 0.06, .meaning = "height of the teeth, as a share of the leaf"});
    visit("teeth", self.teeth, {.min = 8, .max = 80, .meaning = "number of teeth"});
    visit("asymmetry", self.asymmetry,
          {.min = -0.15, .max = 0.15, .meaning = "left half larger, right half smaller by this share"});
    visit("slenderness", self.slenderness,
          {.min = 0.7, .max = 1.6, .meaning = "height over width, against the standard leaf"});
    visit("bend", self.bend,
          {.unit = "degrees", .min = -40, .max = 40, .meaning = "bend of the midrib from stalk to tip"});
  }
};

/// The rest shape of all outlines is the unit circle, counter-clockwise, sampled so that the posed points
/// have a spacing of about `edge_length` along the outline. Outlines of one kind correspond by the angle on
/// the circle.
Body<2> circle_body(const CircleOptions& options, double edge_length);
Body<2> ellipse_body(const EllipseOptions& options, double edge_length);
Body<2> star_body(const StarOptions& options, double edge_length);
Body<2> blob_body(const BlobOptions& options, double edge_length);
/// The stalk is at the bottom, the tip at the top.
Body<2> leaf_body(const LeafOptions& options, double edge_length);

}  // namespace shellmatch
