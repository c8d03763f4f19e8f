#pragma once
/// \file

#include "energies/densities/thin_shell.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// W(Dphi), the simplified volume term of the paper's experiments, without c_vol.
template <int Dim>
struct SimplifiedVolume : CellTerm<Dim> {
  static constexpr TermInfo info{.name = "volume",
                                 .model = "simplified",
                                 .meaning = "W itself, as in the paper's experiments",
                                 .scaled = [](double factor, const TermScales& s) { return factor * s.volume; }};
  using Density = ThinShellDensity<Dim>;
  using Reads = DependsOn<Dphi>;

  template <class T>
  constexpr SmallMat<T, Dim> operator()(const SmallMat<T, Dim>& dphi) const {
    return dphi;
  }
};

}  // namespace shellmatch
