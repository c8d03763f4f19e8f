#pragma once
/// \file
/// How W grows where tangential maps compress and turn over, as functions of det.

#include "energies/autodiff/pack.h"

#include <cmath>

namespace shellmatch {

/// First and second derivative by 1 - det.
struct GrowthDerivatives {
  autodiff::Pack first, second;
};

/// exp(1 - det) (paper, section 3.1).
struct ExponentialGrowth {
  template <class T>
  static constexpr T value(const T& det) {
    using std::exp;
    return exp(1.0 - det);
  }
  static GrowthDerivatives derivatives(const autodiff::Pack& det) {
    const autodiff::Pack e = autodiff::exp_of(1.0 - det);
    return {e, e};
  }
};

/// exp(1 - det) down to det = -3, and its Taylor polynomial of second degree below: convex, twice differentiable, and
/// the same wherever the surface keeps its orientation. A Newton step lowers an exponent by one, but reaches the
/// minimum of a parabola at once. Energies of invertible solids are extrapolated likewise (A. Stomakhin, R. Howes, C.
/// Schroeder, J. Teran: Energetically consistent invertible elasticity. SCA 2012).
struct ExtrapolatedGrowth {
  static constexpr double start = 4;  ///< of 1 - det
  template <class T>
  static constexpr T value(const T& det) {
    using autodiff::max_of;
    using std::exp;
    const T beyond = max_of((1.0 - start) - det, T(0.0));
    return exp(-max_of(det - 1.0, T(-start))) * (1.0 + beyond + 0.5 * (beyond * beyond));
  }
  static GrowthDerivatives derivatives(const autodiff::Pack& det) {
    using autodiff::Pack;
    const Pack e = autodiff::exp_of(-autodiff::max_of(det - 1.0, Pack{} - start));
    return {e * (1.0 + autodiff::max_of((1.0 - start) - det, Pack{})), e};
  }
};

}  // namespace shellmatch
