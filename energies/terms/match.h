#pragma once
/// \file

#include "energies/densities/square.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// |d2(phi) - d1|^2, eq. (def:Ematch) without eta / nu.
template <int Dim>
struct Match : BandTerm<Dim> {
  static constexpr TermInfo info{
      .name = "match",
      .meaning = "squared difference of the signed distances",
      .weight = {"match_weight", 1, {.min = 0, .meaning = "factor on the match term; 0 switches it off"}},
      .scaled = [](double factor, const TermScales& s) { return factor / s.nu; }};
  using Density = SquareDensity<1>;

  template <class T, class P>
  static constexpr SmallVec<T, 1> argument(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>&,
                                           const ReferencePoint<Dim, P>& x, const Material<P>&) {
    return {{y.d2 - x.d1}};
  }
};

}  // namespace shellmatch
