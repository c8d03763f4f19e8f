#include "tests/energies/exact_shapes.h"

#include "grid/octree/constraints.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace shellmatch::test {

namespace {

template <int Dim>
Mat<Dim> projection(const Vec<Dim>& n) {
  return Mat<Dim>::Identity() - n * n.transpose();
}

/// Closest point y of the ellipsoid to x, both from its centre: x = (1 + t / a_i^2) y_i, with t by bisection, and
/// the signed distance.
template <int Dim>
std::pair<Vec<Dim>, double> closest_on_ellipsoid(const Vec<Dim>& half_axes, const Vec<Dim>& x) {
  const Eigen::Array<double, Dim, 1> a2 = half_axes.array().square();
  double low = -a2.minCoeff() * (1 - 1e-12), high = 2;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.5 * (low + high);
    const bool outside = (half_axes.array() * x.array() / (a2 + t)).square().sum() > 1;
    (outside ? low : high) = t;
  }
  const double t = 0.5 * (low + high);
  Vec<Dim> y = a2 * x.array() / (a2 + t);
  // On the medial axis, between the foci, t alone does not say where y is along the shortest axis.
  const double missing = 1 - y.cwiseQuotient(half_axes).squaredNorm();
  int shortest;
  half_axes.minCoeff(&shortest);
  if (missing > 1e-9) y[shortest] = half_axes[shortest] * std::sqrt(missing);
  return {y, std::copysign((x - y).norm(), t)};
}

}  // namespace

template <int Dim>
ExactShape<Dim> sphere(double radius) {
  const auto direction = [](const Vec<Dim>& x) { return Vec<Dim>((x - centre<Dim>()).normalized()); };
  return {[=](const Vec<Dim>& x) { return (x - centre<Dim>()).norm() - radius; }, direction,
          [=](const Vec<Dim>& x) {
            return Mat<Dim>(projection<Dim>(direction(x)) / std::max((x - centre<Dim>()).norm(), 1e-6));
          }};
}

template <int Dim>
ExactShape<Dim> ellipsoid(const Vec<Dim>& half_axes) {
  const Vec<Dim> inverse_squares = half_axes.array().square().inverse();
  const auto closest = [=](const Vec<Dim>& x) { return closest_on_ellipsoid<Dim>(half_axes, x - centre<Dim>()); };
  return {[=](const Vec<Dim>& x) { return closest(x).second; },
          [=](const Vec<Dim>& x) { return Vec<Dim>(inverse_squares.cwiseProduct(closest(x).first).normalized()); },
          [=](const Vec<Dim>& x) {
            const auto [y, distance] = closest(x);
            const Vec<Dim> gradient = inverse_squares.cwiseProduct(y);
            const Mat<Dim> p = projection<Dim>(gradient.normalized());
            const Mat<Dim> s = p * inverse_squares.asDiagonal() * p / std::max(gradient.norm(), 1e-6);
            // The parallel surface at this distance has the shape operator S (I + d S)^{-1}.
            return Mat<Dim>(s * (Mat<Dim>::Identity() + distance * s).inverse());
          }};
}

ExactShape<3> torus(double big_radius, double small_radius) {
  struct Frame {
    double rho, from_core;
    Vec<3> normal, around;
  };
  const auto frame = [=](const Vec<3>& x) {
    const Vec<3> c = x - centre<3>();
    const double rho = std::max(std::hypot(c[0], c[1]), 1e-9);
    const Vec<3> radial = rho > 1e-9 ? Vec<3>(c[0] / rho, c[1] / rho, 0) : Vec<3>::UnitX();
    const Vec<3> from_core = (rho - big_radius) * radial + c[2] * Vec<3>::UnitZ();
    return Frame{rho, std::max(from_core.norm(), 1e-6), from_core.normalized(), Vec<3>(-radial[1], radial[0], 0)};
  };
  return {[=](const Vec<3>& x) { return frame(x).from_core - small_radius; },
          [=](const Vec<3>& x) { return frame(x).normal; },
          [=](const Vec<3>& x) {
            const Frame f = frame(x);
            const Vec<3> along = f.normal.cross(f.around);
            const double around = (f.rho - big_radius) / (f.from_core * f.rho);
            return Mat<3>(along * along.transpose() / f.from_core + around * f.around * f.around.transpose());
          }};
}

template <int Dim>
ExactShape<Dim> moved(const ExactShape<Dim>& shape, const RigidMotion<Dim>& motion) {
  const Mat<Dim> q = motion.rotation;
  const auto back = [=](const Vec<Dim>& y) {
    return Vec<Dim>(q.transpose() * (y - centre<Dim>() - motion.shift) + centre<Dim>());
  };
  return {[=](const Vec<Dim>& y) { return shape.distance(back(y)); },
          [=](const Vec<Dim>& y) { return Vec<Dim>(q * shape.normal(back(y))); },
          [=](const Vec<Dim>& y) { return Mat<Dim>(q * shape.hessian(back(y)) * q.transpose()); }};
}

template <int Dim>
CoefficientFields<Dim> exact_fields(const Octree<Dim>& grid, const ExactShape<Dim>& shape, double exponent) {
  const Classifier classifier{.kind = Classification::absolute, .tau = 1, .cap = 100, .shift = 0};
  CoefficientFields<Dim> f;
  f.distance.resize(grid.n_nodes());
  f.normal.resize(grid.n_nodes());
  f.root.resize(grid.n_nodes());
  for (const Index node : grid.free_nodes()) {
    const Vec<Dim> x = grid.node_position(node);
    f.distance[node] = shape.distance(x);
    f.normal[node] = shape.normal(x);
    const Mat<Dim> extended = extended_shape_operator<Dim>(shape.hessian(x), f.normal[node]);
    f.root[node] = pack_symmetric<Dim>(classified_power<Dim>(extended, classifier, exponent));
  }
  distribute(grid, f.distance);
  distribute(grid, f.normal);
  distribute(grid, f.root);
  return f;
}

template ExactShape<2> sphere<2>(double);
template ExactShape<3> sphere<3>(double);
template ExactShape<2> ellipsoid<2>(const Vec<2>&);
template ExactShape<3> ellipsoid<3>(const Vec<3>&);
template ExactShape<2> moved<2>(const ExactShape<2>&, const RigidMotion<2>&);
template ExactShape<3> moved<3>(const ExactShape<3>&, const RigidMotion<3>&);
template CoefficientFields<2> exact_fields<2>(const Octree<2>&, const ExactShape<2>&, double);
template CoefficientFields<3> exact_fields<3>(const Octree<3>&, const ExactShape<3>&, double);

}  // namespace shellmatch::test
