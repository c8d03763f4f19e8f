#pragma once
/// \file
/// Signed functions of smooth bodies: negative inside, with a gradient of length about 1 near the zero level.

#include "base/types.h"

#include <Eigen/Geometry>

#include <functional>
#include <span>

namespace shellmatch {

/// Negative inside, positive outside, Lipschitz with a constant of at most 2.
using ImplicitFunction = std::function<double(const Vec<3>&)>;

/// A smooth minimum of a and b: min(a, b) - width/6 max(1 - |a - b|/width, 0)^3. It is twice continuously
/// differentiable, so the blended surface has bounded curvature, and equals min(a, b) where |a - b| >= width.
/// width > 0, in units of length.
double smooth_union(double a, double b, double width);

/// The part of `a` outside `b`, with the same rounding.
inline double smooth_difference(double a, double b, double width) { return -smooth_union(-a, b, width); }

/// The convex hull of two balls: centres a, b, radii ra, rb >= 0.
class RoundedCone {
 public:
  /// \pre |a - b| > |ra - rb|
  RoundedCone(const Vec<3>& a, const Vec<3>& b, double ra, double rb);
  /// Distance to it.
  double operator()(const Vec<3>& x) const;

 private:
  Vec<3> a_, axis_;
  double ra_, rb_, length_, sine_, cosine_;
};

/// As RoundedCone, for one point.
inline double rounded_cone(const Vec<3>& x, const Vec<3>& a, const Vec<3>& b, double ra, double rb) {
  return RoundedCone(a, b, ra, rb)(x);
}

/// Distance to the box with the given half sides, centred at 0, whose edges are rounded with `radius`.
/// \pre every half side is at least `radius` >= 0.
double rounded_box(const Vec<3>& x, const Vec<3>& half_sides, double radius);

/// Approximate distance to the ellipsoid with the given semi-axes, centred at 0. The zero level and the
/// gradient on it are exact.
double ellipsoid_function(const Vec<3>& x, const Vec<3>& semi_axes);

/// Distance to a plate: all points within `radius` of the prism over the convex polygon, with half thickness
/// `half_thickness` about the plane x_3 = 0. The corners of the polygon run counter-clockwise in (x_1, x_2).
double rounded_plate(const Vec<3>& x, std::span<const Vec<2>> polygon, double half_thickness, double radius);

/// Gradient of f by central differences with the step 1e-5: accurate to about 1e-10 for these functions.
Vec<3> implicit_gradient(const ImplicitFunction& f, const Vec<3>& x);

/// Moves x along the gradient by Newton steps until |f| < 1e-12, at most ten.
Vec<3> project_to_zero(const ImplicitFunction& f, Vec<3> x);

}  // namespace shellmatch
