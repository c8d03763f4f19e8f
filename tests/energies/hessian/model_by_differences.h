#pragma once
/// \file
/// What Newton's model of a band term has to be, made without the assembly: at every quadrature point the derivative of
/// the term's argument along a direction by differences, in the density's second derivative without its negative modes.

#include "energies/cost/element_cost.h"
#include "energies/densities/positive_hessian.h"
#include "tests/energies/densities/random_matrices.h"
#include "tests/energies/matching_problem.h"
#include "tests/energies/terms/band_density.h"

#include <Eigen/Geometry>

#include <span>
#include <type_traits>

namespace shellmatch::test {

/// Exact second derivative of a density by the entries of its argument.
template <class Density>
auto exact_hessian(const typename Density::template Argument<double>& a, const Material<double>& c) {
  constexpr int n = n_arguments_of<Density>;
  const auto w = detail::second_order<Density, double>(a, c);
  Eigen::Matrix<double, n, n> h;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) h(i, j) = w.h(i, j);
  return h;
}

/// Columns t_1, ..., t_{Dim-1}, n: orthonormal and right-handed. n is a unit vector.
template <int Dim>
Mat<Dim> frame_of(const Vec<Dim>& n) {
  Mat<Dim> q;
  if constexpr (Dim == 2) {
    q.col(0) = Vec<2>(n[1], -n[0]);
  } else {
    q.col(0) = n.unitOrthogonal();
    q.col(1) = n.cross(q.col(0));
  }
  q.col(Dim - 1) = n;
  return q;
}

template <class Term>
class ModelByDifferences {
  static constexpr int dim = Term::dim;

 public:
  /// \param own  values of the term's own options
  ModelByDifferences(const Problem<dim>& problem, std::span<const double> own = {})
      : problem_(problem), material_{problem.options.lambda, problem.options.mu, own.data()} {}

  /// v . H v for a nodal direction v, where H is J^T W''_+ J at phi, integrated over the band.
  double operator()(std::span<const Vec<dim>> phi, std::span<const Vec<dim>> v) const {
    double sum = 0;
    for (const Element<dim>& e : problem_.unknowns.elements()) {
      const ElementFields<dim> fields(e, problem_.geometry, problem_.sigma, problem_.energy.shape());
      for (std::size_t q = 0; q < fields.band.size(); ++q)
        if (fields.band[q].weight > 0) sum += fields.band[q].weight * at_point(e, fields, q, phi, v);
    }
    return sum;
  }

 private:
  struct Point {
    TargetPoint<dim, double> y;
    SmallMat<double, dim> dphi;
  };
  static Point point_at(const Element<dim>& e, const ElementFields<dim>& fields, std::size_t q,
                        std::span<const Vec<dim>> phi, std::span<const Vec<dim>> v, double t) {
    std::array<double, n_corners<dim> * dim> dofs;
    for (int c = 0; c < n_corners<dim>; ++c)
      for (int k = 0; k < dim; ++k) dofs[c * dim + k] = phi[e.nodes[c]][k] + t * v[e.nodes[c]][k];
    SmallVec<double, dim> place;
    Point p;
    deformation_at<dim>(dofs.data(), fields.shape->points[q], fields.side, place, p.dphi);
    p.y = fields.target->template at<double>(place);
    return p;
  }

  double at_point(const Element<dim>& e, const ElementFields<dim>& fields, std::size_t q, std::span<const Vec<dim>> phi,
                  std::span<const Vec<dim>> v) const {
    using Density = typename Term::Density;
    const ReferencePoint<dim, double>& x = fields.band[q].reference;
    const auto argument_at = [&](double t) {
      const Point p = point_at(e, fields, q, phi, v, t);
      return whole_argument<Term>(p.y, p.dphi, x, material_);
    };
    const double t = 1e-6;
    const auto forward = argument_at(t), here = argument_at(0), backward = argument_at(-t);
    constexpr int n = n_arguments_of<Density>;
    Eigen::Matrix<double, n, 1> change;
    for (int i = 0; i < n; ++i) change[i] = (forward.v[i] - backward.v[i]) / (2 * t);
    if constexpr (Term::is_tangential) {
      // W does not change when the frames turn: what counts is the change within the tangent planes.
      using OnTangentMaps = detail::OnTangentMaps<Density, dim>;
      constexpr int m = dim - 1;
      const auto n2 = renormalised(point_at(e, fields, q, phi, v, 0).y.n2);
      const Mat<dim> q1 = frame_of<dim>(Eigen::Map<const Vec<dim>>(x.n1.v.data()));
      const Mat<dim> q2 = frame_of<dim>(Eigen::Map<const Vec<dim>>(n2.v.data()));
      const auto in_frames = [&](const double* entries) {
        const Eigen::Map<const Eigen::Matrix<double, dim, dim, Eigen::RowMajor>> a(entries);
        return Mat<m>((q2.transpose() * a * q1).template topLeftCorner<m, m>());
      };
      const Mat<m> y = in_frames(here.v.data()), dy = in_frames(change.data());
      typename OnTangentMaps::template Argument<double> tangent;
      Eigen::Matrix<double, m * m, 1> d;
      for (int i = 0; i < m * m; ++i) {
        tangent.v[i] = y(i / m, i % m);
        d[i] = dy(i / m, i % m);
      }
      return d.dot(positive_part(exact_hessian<OnTangentMaps>(tangent, material_)) * d);
    } else {
      typename Density::template Argument<double> a;
      a.v = here.v;
      return change.dot(positive_part(exact_hessian<Density>(a, material_)) * change);
    }
  }

  const Problem<dim>& problem_;
  Material<double> material_;
};

}  // namespace shellmatch::test
