#pragma once
/// \file
/// W_hat, the paper's density of the volume term.

#include "energies/densities/material.h"
#include "energies/densities/small_matrix.h"

#include <cmath>

namespace shellmatch {

/// W_hat(A) = alpha |A|^p + beta |cof A|^q + gamma (det A)^{-s} where det A > 0, and NaN elsewhere, which the energy
/// reports as 'cannot be evaluated'. n = 3: p = q = 4, s = 9, alpha = beta = 1, gamma = 4; n = 2: p = q = 3, s = 4,
/// alpha = beta = 2, gamma = 3 sqrt 2. Isotropic and stationary on SO(n); its value there is subtracted, so that
/// energies of different densities compare. Unit: energy per volume. Paper, eq. (def:What) and the paragraph after it.
template <int Dim>
struct FullVolumeDensity {
  template <class T>
  using Argument = SmallMat<T, Dim>;
  static constexpr bool is_isotropic = true;

  template <class T, class P>
  static constexpr T value(const SmallMat<T, Dim>& a, const Material<P>&) {
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
};

}  // namespace shellmatch
