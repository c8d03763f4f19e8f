#pragma once
/// \file
/// Parameters of a stored energy density.

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

}  // namespace shellmatch
