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
  using Reads = DependsOn<Dphi, TargetNormal, ReferenceNormal>;

  template <class T, class P>
  constexpr SmallMat<T, Dim> operator()(const SmallMat<T, Dim>& dphi, const SmallVec<T, Dim>& n2,
                                        const SmallVec<P, Dim>& n1) const {
    return plus_outer(project_columns(dphi, n1), renormalised(n2), n1);
  }
};

}  // namespace shellmatch
