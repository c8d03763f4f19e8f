#pragma once
/// \file
/// Bodies with explicit parametrisations: sphere, ellipsoid, torus.

#include "base/options.h"
#include "geometry/generate/body.h"

namespace shellmatch {

struct SphereOptions {
  double radius = 0.25;
  static void describe(auto& self, auto& visit) {
    visit("radius", self.radius, {.unit = "side of the domain", .min = 0.02, .max = 0.4, .meaning = "radius"});
  }
};

struct EllipsoidOptions {
  double semi_x = 0.36, semi_y = 0.22, semi_z = 0.27;
  static void describe(auto& self, auto& visit) {
    visit("semi_x", self.semi_x,
          {.unit = "side of the domain", .min = 0.02, .max = 0.4, .meaning = "semi-axis along x"});
    visit("semi_y", self.semi_y,
          {.unit = "side of the domain", .min = 0.02, .max = 0.4, .meaning = "semi-axis along y"});
    visit("semi_z", self.semi_z,
          {.unit = "side of the domain", .min = 0.02, .max = 0.4, .meaning = "semi-axis along z"});
  }
};

struct TorusOptions {
  double major_radius = 0.26, minor_radius = 0.1;
  static void describe(auto& self, auto& visit) {
    visit("major_radius", self.major_radius,
          {.unit = "side of the domain",
           .min = 0.05,
           .max = 0.36,
           .meaning = "radius of the circle in the middle of the tube"});
    visit("minor_radius", self.minor_radius,
          {.unit = "side of the domain",
           .min = 0.02,
           .max = 0.2,
           .meaning = "radius of the tube; less than the major radius"});
  }
};

/// The unit sphere as an icosahedron whose faces are subdivided into frequency^2 triangles and projected: 10
/// frequency^2 + 2 vertices. frequency >= 1.
Surface<3> geodesic_sphere(int frequency);

/// Rest shape: a geodesic unit sphere; edges of about `edge_length` after posing. All spheres and ellipsoids
/// correspond point by point.
Body<3> sphere_body(const SphereOptions& options, double edge_length);
Body<3> ellipsoid_body(const EllipsoidOptions& options, double edge_length);

/// Rest shape: the torus with radii 1 and 1/2 about the z axis, a grid of both angles; all tori correspond by
/// their angles. \throws InputError unless minor_radius < 0.95 major_radius.
Body<3> torus_body(const TorusOptions& options, double edge_length);

}  // namespace shellmatch
