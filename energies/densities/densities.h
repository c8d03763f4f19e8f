#pragma once
/// \file
/// Stored energy densities: functions of a matrix A, without geometry and without a grid. All are frame
/// indifferent and vanish, or are stationary, on the rotations. Unit: energy per volume.

#include "energies/densities/small_matrix.h"

#include <cmath>

namespace shellmatch {

/// Lame coefficients, both > 0 for a coercive density.
template <class P>
struct Lame {
  P lambda, mu;
};

/// W(A) = mu/2 |A|^2 + lambda/4 (det A)^2 + (mu + lambda/2) exp(1 - det A) - (n+2) mu/2 - 3 lambda/4.
/// Polyconvex, zero on SO(n), finite everywhere: W(I + tE) = t^2 (mu |sym E|^2 + lambda/2 (tr E)^2) + o(t^2).
/// Paper, section 3.1.
template <class T, class P, int Dim>
constexpr T thin_shell_density(const SmallMat<T, Dim>& a, const Lame<P>& c) {
  using std::exp;
  const T det = determinant(a);
  return 0.5 * c.mu * squared_norm(a) + 0.25 * c.lambda * (det * det) +
         (c.mu + 0.5 * c.lambda) * exp(1.0 - det) - (0.5 * (Dim + 2) * c.mu + 0.75 * c.lambda);
}

/// W_hat(A) = alpha |A|^p + beta |cof A|^q + gamma (det A)^{-s} where det A > 0, and NaN elsewhere, which the
/// energy reports as 'cannot be evaluated'. n = 3: p = q = 4, s = 9, alpha = beta = 1, gamma = 4; n = 2:
/// p = q = 3, s = 4, alpha = beta = 2, gamma = 3 sqrt 2. Stationary on SO(n), its value there subtracted so
/// that energies of different densities compare. Paper, eq. (def:What) and the paragraph after it.
template <class T, int Dim>
constexpr T full_volume_density(const SmallMat<T, Dim>& a) {
  using std::sqrt;
  const T det = determinant(a);
  const T inverse_root = 1.0 / sqrt(det);  // the root makes a negative determinant NaN
  const T inverse = inverse_root * inverse_root;
  const T i2 = inverse * inverse, i4 = i2 * i2;
  const T n2 = squared_norm(a);
  if constexpr (Dim == 3) {
    const T c2 = squared_norm(cofactor(a));
    return n2 * n2 + c2 * c2 + 4.0 * (i4 * i4 * inverse) - 22.0;
  } else {
    // |cof A| = |A| in the plane: 2 |A|^3 + 2 |A|^3.
    constexpr double sqrt2 = 1.4142135623730950488;
    return 4.0 * (n2 * sqrt(n2)) + 3.0 * sqrt2 * i4 - 11.0 * sqrt2;
  }
}

/// Symmetric Dirichlet density, mu/2 (1/2 |A|^2 + 1/2 |A^{-1}|^2 - n): zero on SO(n), treats compression like
/// stretch, infinite as det A -> 0+ and NaN for det A <= 0. Scaled so that its second derivative at I is, as
/// W's, 2 mu |sym E|^2 with lambda = 0. Smith and Schaefer, 'Bijective parameterization with free boundaries',
/// ACM TOG 34(4), 2015.
template <class T, class P, int Dim>
constexpr T symmetric_dirichlet_density(const SmallMat<T, Dim>& a, const P& mu) {
  using std::sqrt;
  const T inverse_root = 1.0 / sqrt(determinant(a));
  const T inverse = inverse_root * inverse_root;
  return 0.5 * mu * (0.5 * squared_norm(a) + 0.5 * (squared_norm(cofactor(a)) * (inverse * inverse)) - 1.0 * Dim);
}

}  // namespace shellmatch
