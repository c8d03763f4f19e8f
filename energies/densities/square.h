#pragma once
/// \file
/// The density of terms that are squares of residuals.

#include "energies/autodiff/pack.h"
#include "energies/densities/material.h"
#include "energies/densities/small_matrix.h"

#include <array>

namespace shellmatch {

/// |r|^2 of a residual with N components; with it Newton's model is the Gauss-Newton model.
template <int N>
struct SquareDensity {
  template <class T>
  using Argument = SmallVec<T, N>;

  template <class T, class P>
  static constexpr T value(const SmallVec<T, N>& r, const Material<P>&) {
    return dot(r, r);
  }

  /// Second derivative by the components, which is positive as it is.
  static std::array<std::array<autodiff::Pack, N>, N> positive_hessian(const SmallVec<autodiff::Pack, N>&,
                                                                       const Material<double>&) {
    std::array<std::array<autodiff::Pack, N>, N> h{};
    for (int i = 0; i < N; ++i) h[i][i] = autodiff::Pack{} + 2.0;
    return h;
  }
};

}  // namespace shellmatch
