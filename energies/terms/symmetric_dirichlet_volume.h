#pragma once
/// \file

#include "energies/densities/symmetric_dirichlet.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// Symmetric Dirichlet energy of Dphi, without c_vol.
template <int Dim>
struct SymmetricDirichletVolume : CellTerm<Dim> {
  static constexpr TermInfo info{
      .name = "volume",
      .model = "symmetric_dirichlet",
      .meaning = "treats compression like stretch and is infinite at folds",
      .weight = {"volume_weight", 1, {.min = 0, .meaning = "factor on the volume term; 0 switches it off"}},
      .scaled = [](double factor, const TermScales& s) { return factor * s.volume; },
      .forbids_folds = true};
  using Density = SymmetricDirichletDensity<Dim>;
  using Reads = DependsOn<Dphi>;

  template <class T>
  constexpr SmallMat<T, Dim> operator()(const SmallMat<T, Dim>& dphi) const {
    return dphi;
  }
};

}  // namespace shellmatch
