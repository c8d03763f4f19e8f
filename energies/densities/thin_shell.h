#pragma once
/// \file
/// W, the density of membrane and bending, and of the simplified volume term.

#include "energies/densities/material.h"
#include "energies/densities/small_matrix.h"
#include "energies/densities/thin_shell_hessian.h"

#include <cmath>

namespace shellmatch {

/// W(A) = mu/2 |A|^2 + lambda/4 (det A)^2 + (mu + lambda/2) exp(1 - det A) - (n+2) mu/2 - 3 lambda/4.
/// Polyconvex, frame indifferent, isotropic, zero on SO(n), finite everywhere: W(I + tE) = t^2 (mu |sym E|^2 + lambda/2
/// (tr E)^2) + o(t^2). Unit: energy per volume. Paper, section 3.1. On tangential maps the positive
/// part of its second derivative has a closed form.
template <int Dim>
struct ThinShellDensity {
  template <class T>
  using Argument = SmallMat<T, Dim>;
  static constexpr bool is_isotropic = true;

  template <class T, class P>
  static constexpr T value(const SmallMat<T, Dim>& a, const Material<P>& c) {
    using std::exp;
    const T det = determinant(a);
    return 0.5 * c.mu * squared_norm(a) + 0.25 * c.lambda * (det * det) + (c.mu + 0.5 * c.lambda) * exp(1.0 - det) -
           (0.5 * (Dim + 2) * c.mu + 0.75 * c.lambda);
  }

  /// Positive part of the second derivative on tangential maps, by the entries of Y (thin_shell_hessian.h).
  template <class Entries>
  static auto positive_tangent_hessian(const Entries& y, const Material<double>& c) {
    return thin_shell_tangent_hessian<Dim>(y, c);
  }
};

}  // namespace shellmatch
