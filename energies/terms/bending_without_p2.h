#pragma once
/// \file

#include "energies/densities/thin_shell.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// W(N^{1/2} Dphi P1 M^{-1/2} P1 + n2 n1^T): bending with P2 left out.
template <int Dim>
struct BendingWithoutP2 : BandTerm<Dim> {
  static constexpr TermInfo info{
      .name = "bending",
      .model = "no_p2",
      .meaning = "leaves out the projection P2; to compare with",
      .scaled = [](double factor, const TermScales& s) { return factor * s.delta * s.delta * s.delta; }};
  using Density = ThinShellDensity<Dim>;
  using Reads = DependsOn<Dphi, TargetNormal, TargetRoot, ReferenceNormal, ReferenceRoot>;

  template <class T, class P>
  constexpr SmallMat<T, Dim> operator()(const SmallMat<T, Dim>& dphi, const SmallVec<T, Dim>& n2,
                                        const SmallSym<T, Dim>& root, const SmallVec<P, Dim>& n1,
                                        const SmallSym<P, Dim>& r1) const {
    return plus_outer(product<Dim>(root, product<Dim>(dphi, r1)), renormalised(n2), n1);
  }
};

}  // namespace shellmatch
