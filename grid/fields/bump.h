#pragma once
/// \file
/// The bump function eta_sigma, the density of the band of half width sigma around a surface (paper, section
/// 3).

#include <cmath>

namespace shellmatch {

/// The constant c of eta_sigma: 1 / integral of exp(-1/(1 - t^2)) over (-1, 1), to 20 digits.
inline constexpr double bump_constant = 2.25228362104358101050;

/// eta_sigma(t) = c/sigma exp(-1/(1 - (t/sigma)^2)) for |t| < sigma, else 0: even, infinitely smooth, with
/// integral 1. Unit 1/length. \pre sigma > 0
inline double bump(double t, double sigma) {
  const double s = t / sigma;
  const double gap = 1 - s * s;
  return gap > 0 ? bump_constant / sigma * std::exp(-1 / gap) : 0.0;
}

}  // namespace shellmatch
