#pragma once
/// \file
/// One term of the band at eight quadrature points, and the terms that are there to compare with: they are
/// compiled apart from the production path (energies/assembly/band_terms.cpp), which calls its own kernels directly.

#include "energies/autodiff/compiled.h"
#include "energies/terms/integrands.h"
#include "energies/options.h"

namespace shellmatch {

/// Arrays of one batch of points: inputs of the functors and what they give back.
template <int Dim>
struct PointArrays {
  static constexpr int n_target = TargetPoint<Dim, double>::size;
  static constexpr int n_active = n_target + Dim * Dim;
  static constexpr int n_passive = ReferencePoint<Dim, double>::size + 2;
  std::array<autodiff::Pack, n_active> active;
  std::array<autodiff::Pack, n_passive> passive;
  std::array<autodiff::Pack, n_active> adjoint;
  std::array<std::array<autodiff::Pack, n_target>, Dim>
      derivative;  ///< of the target's values by the coordinates of phi
};

/// Weighted sum of a term over the lanes' points; adds the weighted derivative to p.adjoint.
template <class Functor, int Dim, bool WithGradient>
[[gnu::noinline]] autodiff::Pack apply_term(PointArrays<Dim>& p, autodiff::Pack seed) {
  using Code = autodiff::Compiled<Functor>;
  if constexpr (WithGradient) {
    std::array<autodiff::Pack, PointArrays<Dim>::n_active> adjoint;
    const autodiff::Pack v = Code::gradient(p.active.data(), p.passive.data(), seed, adjoint.data());
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (
          [&] {
            if constexpr (Code::reads_active(static_cast<int>(I))) p.adjoint[I] += adjoint[I];
          }(),
          ...);
    }
    (std::make_index_sequence<PointArrays<Dim>::n_active>{});
    return v * seed;
  } else {
    return Code::value(p.active.data(), p.passive.data()) * seed;
  }
}

/// Adds the weighted derivative to p.adjoint if there is one to compute; returns the weighted values.
template <int Dim>
using TermKernel = autodiff::Pack (*)(PointArrays<Dim>& p, autodiff::Pack seed);

/// The kernel of a term to compare with, null for thin_shell.
template <int Dim, bool WithGradient>
TermKernel<Dim> comparison_kernel(MembraneModel model);
template <int Dim, bool WithGradient>
TermKernel<Dim> comparison_kernel(BendingModel model);

}  // namespace shellmatch
