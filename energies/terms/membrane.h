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
  static constexpr bool is_tangential = true;

  template <class T, class P>
  static constexpr SmallMat<T, Dim> argument(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                                             const ReferencePoint<Dim, P>& x, const Material<P>&) {
    return project_rows(project_columns(dphi, x.n1), renormalised(y.n2));
  }
};

}  // namespace shellmatch
