#pragma once
/// \file

#include "energies/densities/material.h"
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
  using Reads = DependsOn<TargetDistance, ReferenceDistance>;

  template <class T, class P>
  constexpr SmallVec<T, 1> operator()(const T& d2, const P& d1) const {
    return {{d2 - d1}};
  }
};

}  // namespace shellmatch
