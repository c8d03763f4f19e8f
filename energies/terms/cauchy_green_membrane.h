#pragma once
/// \file

#include "energies/densities/thin_shell.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// W((Dphi P1)^T Dphi P1 + n1 n1^T), eq. (eq:badMem): vanishes for every tangential isometry, oscillating ones
/// included, and is not rank-one convex (paper, section 4.1). It reads nothing of the template.
template <int Dim>
struct CauchyGreenMembrane : BandTerm<Dim> {
  static constexpr TermInfo info{.name = "membrane",
                                 .model = "cauchy_green",
                                 .meaning = "takes W of the Cauchy-Green tensor; to compare with",
                                 .scaled = [](double factor, const TermScales& s) { return factor * s.delta; }};
  using Density = ThinShellDensity<Dim>;
  using Reads = DependsOn<Dphi, ReferenceNormal>;

  template <class T, class P>
  constexpr SmallMat<T, Dim> operator()(const SmallMat<T, Dim>& dphi, const SmallVec<P, Dim>& n1) const {
    const auto tangential = project_columns(dphi, n1);
    SmallMat<T, Dim> c;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        c(i, j) = tangential(0, i) * tangential(0, j);
        for (int k = 1; k < Dim; ++k) c(i, j) = c(i, j) + tangential(k, i) * tangential(k, j);
      }
    return plus_outer(c, n1, n1);
  }
};

}  // namespace shellmatch
