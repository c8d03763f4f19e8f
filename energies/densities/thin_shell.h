#pragma once
/// \file
/// W, the density of membrane and bending, and of the simplified volume term.

#include "energies/densities/growth.h"
#include "energies/densities/material.h"
#include "energies/densities/small_matrix.h"
#include "energies/densities/thin_shell_hessian.h"

namespace shellmatch {

/// W(A) = mu/2 |A|^2 + lambda/4 (det A)^2 + (mu + lambda/2) g(det A) - (n+2) mu/2 - 3 lambda/4, g the growth.
/// Polyconvex, frame indifferent, isotropic, zero on SO(n), finite everywhere: W(I + tE) = t^2 (mu |sym E|^2 + lambda/2
/// (tr E)^2) + o(t^2). Unit: energy per volume. On tangential maps the positive part of its second derivative has a
/// closed form.
template <int Dim, class Growth>
struct ThinShellOf {
  template <class T>
  using Argument = SmallMat<T, Dim>;
  static constexpr bool is_isotropic = true;

  template <class T, class P>
  static constexpr T value(const SmallMat<T, Dim>& a, const Material<P>& c) {
    const T det = determinant(a);
    return 0.5 * c.mu * squared_norm(a) + 0.25 * c.lambda * (det * det) + (c.mu + 0.5 * c.lambda) * Growth::value(det) -
           (0.5 * (Dim + 2) * c.mu + 0.75 * c.lambda);
  }

  /// Positive part of the second derivative on tangential maps, by the entries of Y (thin_shell_hessian.h).
  template <class Entries>
  static auto positive_tangent_hessian(const Entries& y, const Material<double>& c) {
    return thin_shell_tangent_hessian<Dim, Growth>(y, c);
  }
};

/// The paper's, section 3.1.
template <int Dim>
struct ThinShellDensity : ThinShellOf<Dim, ExponentialGrowth> {};

/// The same for det A >= -3, with quadratic growth below.
template <int Dim>
struct ExtrapolatedThinShellDensity : ThinShellOf<Dim, ExtrapolatedGrowth> {};

}  // namespace shellmatch
