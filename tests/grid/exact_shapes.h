#pragma once
/// \file
/// Surfaces whose distance and its derivatives are known exactly.

#include "base/types.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <functional>
#include <utility>

namespace shellmatch::test {

// A surface by its distance and the Hessian of the distance, both exact wherever they are asked for.
template <int Dim>
struct ExactShape {
  std::function<double(const Vec<Dim>&)> distance;
  std::function<Mat<Dim>(const Vec<Dim>&)> hessian;

  /// Gradient of the distance, by central differences of the fourth order: good to 1e-10.
  Vec<Dim> normal(const Vec<Dim>& x) const {
    const double step = 1e-3;
    Vec<Dim> g;
    for (int k = 0; k < Dim; ++k) {
      const Vec<Dim> e = step * Vec<Dim>::Unit(k);
      g[k] = (8 * (distance(x + e) - distance(x - e)) - (distance(x + 2 * e) - distance(x - 2 * e))) / (12 * step);
    }
    return g.normalized();
  }
};

template <int Dim>
ExactShape<Dim> sphere(double radius) {
  return {[=](const Vec<Dim>& y) { return (y - Vec<Dim>::Constant(0.5)).norm() - radius; },
          [](const Vec<Dim>& y) {
            const Vec<Dim> x = y - Vec<Dim>::Constant(0.5);
            const Vec<Dim> n = x.normalized();
            return Mat<Dim>((Mat<Dim>::Identity() - n * n.transpose()) / x.norm());
          }};
}

// Torus around the z axis through the centre of the domain: d = sqrt((rho - big)^2 + z^2) - small.
inline ExactShape<3> torus(double big, double small) {
  return {[=](const Vec<3>& y) {
            const Vec<3> x = y - Vec<3>::Constant(0.5);
            return std::hypot(std::hypot(x[0], x[1]) - big, x[2]) - small;
          },
          [=](const Vec<3>& y) {
            const Vec<3> x = y - Vec<3>::Constant(0.5);
            const double rho = std::hypot(x[0], x[1]), s = rho - big, r = std::hypot(s, x[2]);
            const Vec<3> radial(x[0] / rho, x[1] / rho, 0), around(-radial[1], radial[0], 0);
            const Vec<3> n = (s * radial + x[2] * Vec<3>::UnitZ()) / r, along = n.cross(around);
            // 1/r along the tube, the cosine of the tube's angle over rho around the axis.
            return Mat<3>(along * along.transpose() / r + around * around.transpose() * (s / r) / rho);
          }};
}

// Ellipsoid with these half axes. The closest point x solves (1 + t/a_i^2) x_i = y_i; t is found by
// bisection. On the disc of medial points t is the lowest possible, and the shortest axis takes what is left.
template <int Dim>
std::pair<Vec<Dim>, double> closest_on_ellipsoid(const Vec<Dim>& axes, const Vec<Dim>& y) {
  const Vec<Dim> squares = axes.cwiseProduct(axes);
  int shortest;
  const double smallest = squares.minCoeff(&shortest);
  double low = -smallest * (1 - 1e-12), high = 10;
  const auto level = [&](double t) {
    return (axes.cwiseProduct(y).array() / (squares.array() + t)).square().sum() - 1;
  };
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (level(middle) > 0 ? low : high) = middle;
  }
  const double t = 0.5 * (low + high);
  Vec<Dim> x = squares.array() * y.array() / (squares.array() + t);
  if (level(t) < -1e-3) x[shortest] = axes[shortest] * std::sqrt(-level(t));
  return {x, (y - x).norm() * (t < 0 ? -1 : 1)};
}

template <int Dim>
ExactShape<Dim> ellipsoid(const Vec<Dim>& axes) {
  const auto centred = [](const Vec<Dim>& y) { return Vec<Dim>(y - Vec<Dim>::Constant(0.5)); };
  return {[=](const Vec<Dim>& y) { return closest_on_ellipsoid<Dim>(axes, centred(y)).second; },
          [=](const Vec<Dim>& y) {
            const auto [x, d] = closest_on_ellipsoid<Dim>(axes, centred(y));
            const Vec<Dim> squares = axes.cwiseProduct(axes);
            const Vec<Dim> gradient = x.cwiseQuotient(squares);
            const Vec<Dim> n = gradient.normalized();
            const Mat<Dim> p = Mat<Dim>::Identity() - n * n.transpose();
            const Mat<Dim> s = p * squares.cwiseInverse().asDiagonal() * p / gradient.norm();
            // On the parallel surface at distance d: S (I + d S)^-1.
            return Mat<Dim>(s * (Mat<Dim>::Identity() + d * s).inverse());
          }};
}

}  // namespace shellmatch::test
