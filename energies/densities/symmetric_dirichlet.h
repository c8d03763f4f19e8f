#pragma once
/// \file
/// Symmetric Dirichlet density.

#include "energies/densities/material.h"
#include "energies/densities/small_matrix.h"

#include <cmath>

namespace shellmatch {

/// mu/2 (1/2 |A|^2 + 1/2 |A^{-1}|^2 - n): zero on SO(n), isotropic, treats compression like stretch, infinite as
/// det A -> 0+ and NaN for det A <= 0. Scaled so that its second derivative at I is 2 mu |sym E|^2, as W's with lambda
/// = 0. Unit: energy per volume. Smith and Schaefer, 'Bijective parameterization with free boundaries', ACM TOG 34(4),
/// 2015.
template <int Dim>
struct SymmetricDirichletDensity {
  template <class T>
  using Argument = SmallMat<T, Dim>;
  static constexpr bool is_isotropic = true;

  template <class T, class P>
  static constexpr T value(const SmallMat<T, Dim>& a, const Material<P>& c) {
    using std::sqrt;
    const T inverse_root = 1.0 / sqrt(determinant(a));
    const T inverse = inverse_root * inverse_root;
    return 0.5 * c.mu * (0.5 * squared_norm(a) + 0.5 * (squared_norm(cofactor(a)) * (inverse * inverse)) - 1.0 * Dim);
  }
};

}  // namespace shellmatch
