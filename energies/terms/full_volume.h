#pragma once
/// \file

#include "energies/densities/full_volume.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// W_hat(Dphi), eq. (def:Evol), without c_vol.
template <int Dim>
struct FullVolume : CellTerm<Dim> {
  static constexpr TermInfo info{.name = "volume",
                                 .model = "full",
                                 .meaning = "the paper's W_hat, infinite at folds",
                                 .scaled = [](double factor, const TermScales& s) { return factor * s.volume; },
                                 .forbids_folds = true};
  using Density = FullVolumeDensity<Dim>;
  using Reads = DependsOn<Dphi>;

  template <class T>
  constexpr SmallMat<T, Dim> operator()(const SmallMat<T, Dim>& dphi) const {
    return dphi;
  }
};

}  // namespace shellmatch
