#pragma once
/// \file
/// Shapes whose signed distance, normal and shape operator are known exactly, and their coefficients at the nodes.

#include "grid/fits/curvature.h"

#include <functional>

namespace shellmatch::test {

/// A shape by its signed distance and the first and second derivative of that.
template <int Dim>
struct ExactShape {
  std::function<double(const Vec<Dim>&)> distance;
  std::function<Vec<Dim>(const Vec<Dim>&)> normal;
  std::function<Mat<Dim>(const Vec<Dim>&)> hessian;
};

/// The centre of the domain.
template <int Dim>
Vec<Dim> centre() {
  return Vec<Dim>::Constant(0.5);
}

/// Around the centre of the domain.
template <int Dim>
ExactShape<Dim> sphere(double radius);

/// Around the centre of the domain, with these half axes.
template <int Dim>
ExactShape<Dim> ellipsoid(const Vec<Dim>& half_axes);

/// Around the z axis through the centre of the domain.
ExactShape<3> torus(double big_radius, double small_radius);

/// x -> Q (x - centre) + centre + shift.
template <int Dim>
struct RigidMotion {
  Mat<Dim> rotation;
  Vec<Dim> shift;
  Vec<Dim> operator()(const Vec<Dim>& x) const { return rotation * (x - centre<Dim>()) + centre<Dim>() + shift; }
};

/// The shape carried along by the motion.
template <int Dim>
ExactShape<Dim> moved(const ExactShape<Dim>& shape, const RigidMotion<Dim>& motion);

/// d, n and C(S)^exponent at the nodes, from the exact derivatives; hanging nodes get the mean of their parents.
/// Curvatures are classified with tau = 1 and cut at 100, which no band of these tests reaches.
template <int Dim>
CoefficientFields<Dim> exact_fields(const Octree<Dim>& grid, const ExactShape<Dim>& shape, double exponent = 0.5);

}  // namespace shellmatch::test
