#pragma once
/// \file
/// What a stored energy density W is, and its parameters. A density is a struct with
///
///     template <class T> using Argument = SmallMat<T, Dim>;                           or SmallVec<T, N> of a residual
///     template <class T, class P>
///     static constexpr T value(const Argument<T>& a, const Material<P>& material);    W(a)
///
/// The density of a corner term takes a number and needs no Argument. Optional are `is_isotropic`, which says that
/// W(Q A R) = W(A) for rotations Q and R, `positive_hessian` and `positive_tangent_hessian`: ways to the positive part
/// of W'' that are cheaper than automatic differentiation (energies/densities/positive_hessian.h).

#include "energies/autodiff/pack.h"
#include "energies/densities/small_matrix.h"

#include <array>

namespace shellmatch {

/// Lame coefficients, lambda >= 0 and mu > 0 for a coercive density, and what a density or term has of its own: the
/// options that its term lists (energies/terms/term.h), in their order. P is a number, a Pack or a recording scalar.
template <class P>
struct Material {
  P lambda, mu;
  const P* own = nullptr;
};

/// Number of entries of a density's argument.
template <class Density>
inline constexpr int n_arguments_of = Density::template Argument<double>::size;

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
