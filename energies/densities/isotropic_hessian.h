#pragma once
/// \file
/// Positive semidefinite second derivative of an isotropic density at a matrix A, by its principal stretches, eight
/// matrices at a time.
///
/// A = U diag(s) V^T with rotations U, V (the smallest stretch carries the sign of det A) and density psi(s).
/// In the frames U and V the second derivative splits into the Hessian of psi on the diagonal and, for each
/// pair (i, j), a twist (e_i e_j^T - e_j e_i^T) with eigenvalue (psi_i + psi_j)/(s_i + s_j) and a flip (e_i
/// e_j^T + e_j e_i^T) with (psi_i - psi_j)/(s_i - s_j). Smith, de Goes and Kim, 'Analytic eigensystems for
/// isotropic distortion energies', ACM TOG 38(1), 2019. psi and its derivatives come from the density itself, by
/// second-order automatic differentiation.

#include "energies/autodiff/pack.h"
#include "energies/autodiff/second_order.h"
#include "energies/densities/material.h"
#include "energies/densities/small_matrix.h"
#include "energies/densities/square_pack.h"

#include <array>

namespace shellmatch {

/// A = U diag(s) V^T.
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

}  // namespace shellmatch
