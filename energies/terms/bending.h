#pragma once
/// \file

#include "energies/densities/thin_shell.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// W(Lambda), Lambda = P2 N^{1/2} P2 Dphi P1 M^{-1/2} P1 + n2 n1^T, eq. (def:Ebend) without delta^3 eta.
template <int Dim>
struct Bending : BandTerm<Dim> {
  static constexpr TermInfo info{
      .name = "bending",
      .model = "thin_shell",
      .meaning = "the paper's",
      .scaled = [](double factor, const TermScales& s) { return factor * s.delta * s.delta * s.delta; }};
  using Density = ThinShellDensity<Dim>;
  using Reads = DependsOn<Dphi, TargetNormal, TargetRoot, ReferenceRoot>;
  static constexpr bool is_tangential = true;

  template <class T, class P>
  constexpr SmallMat<T, Dim> operator()(const SmallMat<T, Dim>& dphi, const SmallVec<T, Dim>& normal,
                                        const SmallSym<T, Dim>& root, const SmallSym<P, Dim>& r1) const {
    const auto n2 = renormalised(normal);
    return project_rows(product<Dim>(root, project_rows(product<Dim>(dphi, r1), n2)), n2);
  }
};

}  // namespace shellmatch
