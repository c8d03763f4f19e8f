#pragma once
/// \file

#include "energies/densities/thin_shell.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// W(Dphi P1 + n2 n1^T): the membrane with P2 left out (paper, fig:cubes). Derivatives that leave the template's
/// tangent plane count as stretch, even where phi still has to find its way there.
template <int Dim>
struct MembraneWithoutP2 : BandTerm<Dim> {
  static constexpr TermInfo info{.name = "membrane",
                                 .model = "no_p2",
                                 .meaning = "leaves out the projection P2; to compare with",
                                 .scaled = [](double factor, const TermScales& s) { return factor * s.delta; }};
  using Density = ThinShellDensity<Dim>;

  template <class T, class P>
  static constexpr SmallMat<T, Dim> argument(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                                             const ReferencePoint<Dim, P>& x, const Material<P>&) {
    return plus_outer(project_columns(dphi, x.n1), renormalised(y.n2), x.n1);
  }
};

}  // namespace shellmatch
