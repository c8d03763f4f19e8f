#pragma once
/// \file

#include "energies/densities/thin_shell.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// W(P2 Dphi P1 + n2 n1^T), eq. (def:Emem) without delta eta.
template <int Dim>
struct Membrane : BandTerm<Dim> {
  static constexpr TermInfo info{
      .name = "membrane",
      .model = "thin_shell",
      .meaning = "the paper's",
      .weight = {"membrane_weight", 1, {.min = 0, .meaning = "factor on the membrane term; 0 switches it off"}},
      .scaled = [](double factor, const TermScales& s) { return factor * s.delta; }};
  using Density = ThinShellDensity<Dim>;
  using Reads = DependsOn<Dphi, TargetNormal, ReferenceNormal>;
  static constexpr bool is_tangential = true;

  template <class T, class P>
  constexpr SmallMat<T, Dim> operator()(const SmallMat<T, Dim>& dphi, const SmallVec<T, Dim>& n2,
                                        const SmallVec<P, Dim>& n1) const {
    return project_rows(project_columns(dphi, n1), renormalised(n2));
  }
};

}  // namespace shellmatch
