#pragma once
/// \file

#include "energies/densities/material.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// |Dphi^T S2 Dphi - S1|^2, which is not rank-one convex (paper, section 3.2).
template <int Dim>
struct QuadraticBending : BandTerm<Dim> {
  static constexpr TermInfo info{
      .name = "bending",
      .model = "quadratic",
      .meaning = "is |Dphi^T S2 Dphi - S1|^2; to compare with",
      .scaled = [](double factor, const TermScales& s) { return factor * s.delta * s.delta * s.delta; }};
  using Density = SquareDensity<Dim * Dim>;
  using Reads = DependsOn<Dphi, TargetShapeOperator, ReferenceShapeOperator>;

  template <class T, class P>
  constexpr SmallVec<T, Dim * Dim> operator()(const SmallMat<T, Dim>& dphi, const SmallSym<T, Dim>& s2,
                                              const SmallSym<P, Dim>& s1) const {
    const auto s2_dphi = product<Dim>(s2, dphi);
    SmallVec<T, Dim * Dim> gap;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        T pulled_back = dphi(0, i) * s2_dphi(0, j);
        for (int k = 1; k < Dim; ++k) pulled_back = pulled_back + dphi(k, i) * s2_dphi(k, j);
        gap[i * Dim + j] = pulled_back - s1(i, j);
      }
    return gap;
  }
};

}  // namespace shellmatch
