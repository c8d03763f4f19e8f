#pragma once
/// \file

#include "energies/densities/square.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// |Dphi^T S2 Dphi - S1|^2, which is not rank-one convex (paper, section 3.2). It reads the shape operators themselves:
/// y.root is S2 and x.r1 is S1.
template <int Dim>
struct QuadraticBending : BandTerm<Dim> {
  static constexpr TermInfo info{
      .name = "bending",
      .model = "quadratic",
      .meaning = "is |Dphi^T S2 Dphi - S1|^2; to compare with",
      .scaled = [](double factor, const TermScales& s) { return factor * s.delta * s.delta * s.delta; }};
  using Density = SquareDensity<Dim * Dim>;
  static constexpr bool reads_shape_operators = true;

  template <class T, class P>
  static constexpr SmallVec<T, Dim * Dim> argument(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                                                   const ReferencePoint<Dim, P>& x, const Material<P>&) {
    const auto s2_dphi = product<Dim>(y.root, dphi);
    SmallVec<T, Dim * Dim> gap;
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        T pulled_back = dphi(0, i) * s2_dphi(0, j);
        for (int k = 1; k < Dim; ++k) pulled_back = pulled_back + dphi(k, i) * s2_dphi(k, j);
        gap[i * Dim + j] = pulled_back - x.r1(i, j);
      }
    return gap;
  }
};

}  // namespace shellmatch
