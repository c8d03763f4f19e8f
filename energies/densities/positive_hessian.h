#pragma once
/// \file
/// The positive semidefinite part of a density's second derivative W''(A) by the entries of A: what Newton's model
/// takes in the place of W''. A density may bring its own closed form (`positive_hessian`), or say that it is isotropic
/// (`is_isotropic`: W(Q A R) = W(A) for rotations Q and R), which gives its eigenvectors by principal stretches; of any
/// other density W'' comes from second-order automatic differentiation and its negative eigenvalues are set to 0.

#include "base/decompositions.h"
#include "energies/autodiff/pack.h"
#include "energies/autodiff/second_order.h"
#include "energies/densities/material.h"
#include "energies/densities/pack_eigen.h"
#include "energies/densities/small_matrix.h"

#include <array>
#include <type_traits>

namespace shellmatch {

/// A = U diag(s) V^T.
/// An isotropic density at A = U diag(s) V^T with rotations U, V is psi(s). In the frames U and V its second derivative
/// splits into the Hessian of psi on the diagonal and, for each pair (i, j), a twist (e_i e_j^T - e_j e_i^T) with
/// eigenvalue (psi_i + psi_j)/(s_i + s_j) and a flip (e_i e_j^T + e_j e_i^T) with (psi_i - psi_j)/(s_i - s_j). Smith,
/// de Goes and Kim, 'Analytic eigensystems for isotropic distortion energies', ACM TOG 38(1), 2019. Eight matrices at a
/// time; psi and its derivatives come from the density itself, by second-order automatic differentiation.
template <int Dim>
struct Stretches {
  SmallMat<autodiff::Pack, Dim> u, v;
  std::array<autodiff::Pack, Dim> s;  ///< the first is the smallest and carries the sign of det A
};

template <int Dim>
Stretches<Dim> principal_stretches(const SmallMat<autodiff::Pack, Dim>& a);

/// psi with its derivatives by the stretches.
template <class Density, int Dim>
autodiff::SecondOrder<Dim, autodiff::Pack> density_of_stretches(const std::array<autodiff::Pack, Dim>& s,
                                                                const Material<double>& c) {
  using Scalar = autodiff::SecondOrder<Dim, autodiff::Pack>;
  SmallMat<Scalar, Dim> diagonal;
  for (int i = 0; i < Dim; ++i) diagonal(i, i) = Scalar::variable(s[i], i);
  return Density::template value<Scalar, double>(diagonal, c);
}

/// Second derivative by the entries of A in row order, its negative modes removed.
template <int Dim>
SquarePack<Dim * Dim> projected_hessian(const Stretches<Dim>& a, const autodiff::SecondOrder<Dim, autodiff::Pack>& psi);

namespace detail {

template <class Density, class V>
autodiff::SecondOrder<n_arguments_of<Density>, V> second_order(const typename Density::template Argument<V>& a,
                                                               const Material<double>& c) {
  using Scalar = autodiff::SecondOrder<n_arguments_of<Density>, V>;
  typename Density::template Argument<Scalar> x;
  for (int i = 0; i < n_arguments_of<Density>; ++i) x.v[i] = Scalar::variable(a.v[i], i);
  return Density::template value<Scalar, double>(x, c);
}

template <class Density>
concept HasClosedForm = requires(const typename Density::template Argument<autodiff::Pack>& a,
                                 const Material<double>& c) {
  Density::positive_hessian(a, c);
};
template <class Density>
concept IsIsotropic = requires {
  requires Density::is_isotropic;
};

/// W as a density of Y, the matrix of a tangential map.
template <class Density, int Dim>
struct OnTangentMaps {
  template <class T>
  using Argument = SmallVec<T, (Dim - 1) * (Dim - 1)>;
  template <class T, class P>
  static T value(const Argument<T>& y, const Material<P>& c) {
    SmallMat<T, Dim> a;
    for (T& entry : a.v) entry = T(0.0);
    a(Dim - 1, Dim - 1) = T(1.0);
    for (int i = 0; i < Dim - 1; ++i)
      for (int j = 0; j < Dim - 1; ++j) a(i, j) = y.v[i * (Dim - 1) + j];
    return Density::template value<T, P>(a, c);
  }
};

}  // namespace detail

/// Positive semidefinite part of W'' at eight arguments. \pre W is finite there
template <class Density>
SquarePack<n_arguments_of<Density>> positive_hessian(const typename Density::template Argument<autodiff::Pack>& a,
                                                     const Material<double>& c) {
  using autodiff::Pack;
  constexpr int n = n_arguments_of<Density>;
  if constexpr (detail::HasClosedForm<Density>) {
    return Density::positive_hessian(a, c);
  } else if constexpr (detail::IsIsotropic<Density>) {
    constexpr int dim = n == 4 ? 2 : 3;
    const Stretches<dim> stretches = principal_stretches<dim>(a);
    return projected_hessian<dim>(stretches, density_of_stretches<Density, dim>(stretches.s, c));
  } else {
    const auto w = detail::second_order<Density, Pack>(a, c);
    SquarePack<n> h;
    for (int lane = 0; lane < autodiff::pack_size; ++lane) {
      std::array<double, n * n> m;
      for (int i = 0; i < n * n; ++i) m[i] = w.h(i / n, i % n)[lane];
      remove_negative_eigenvalues(n, m.data());
      for (int i = 0; i < n * n; ++i) h[i / n][i % n][lane] = m[i];
    }
    return h;
  }
}

/// The same of an isotropic density on tangential maps, whose matrix in orthonormal frames of both shapes is Y beside a
/// 1: by the entries of Y in row order.
template <class Density, int Dim>
SquarePack<(Dim - 1) * (Dim - 1)> positive_tangent_hessian(const std::array<autodiff::Pack, (Dim - 1) * (Dim - 1)>& y,
                                                           const Material<double>& c) {
  static_assert(Density::is_isotropic, "the frames of a tangential map are free: W may not depend on them");
  if constexpr (requires { Density::positive_tangent_hessian(y, c); }) return Density::positive_tangent_hessian(y, c);
  else return positive_hessian<detail::OnTangentMaps<Density, Dim>>({y}, c);
}

/// Largest second derivative of W in a direction of norm 1, at I for matrices and at 0 for residuals: 2 mu + n lambda
/// for the density of the thin shell.
template <class Density>
double largest_second_derivative(const Material<double>& c) {
  constexpr int n = n_arguments_of<Density>;
  using Argument = typename Density::template Argument<autodiff::Pack>;
  Argument rest{};
  if constexpr (std::is_same_v<Argument, SmallMat<autodiff::Pack, 2>> ||
                std::is_same_v<Argument, SmallMat<autodiff::Pack, 3>>)
    for (int i = 0; i * i < n; ++i) rest(i, i) = autodiff::Pack{} + 1.0;
  const auto h = positive_hessian<Density>(rest, c);
  std::array<double, n * n> m;
  for (int i = 0; i < n * n; ++i) m[i] = h[i / n][i % n][0];
  return largest_eigenvalue(n, m.data());
}

}  // namespace shellmatch
