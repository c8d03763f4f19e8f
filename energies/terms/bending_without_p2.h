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

  template <class T, class P>
  static constexpr SmallMat<T, Dim> argument(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                                             const ReferencePoint<Dim, P>& x, const Material<P>&) {
    return plus_outer(product<Dim>(y.root, product<Dim>(dphi, x.r1)), renormalised(y.n2), x.n1);
  }
};

}  // namespace shellmatch
