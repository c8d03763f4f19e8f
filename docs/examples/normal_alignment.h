#pragma once
/// \file
/// A term that is not in the program, and all that is written for it: the example of docs/adding-an-energy.md.

#include "energies/densities/material.h"
#include "energies/terms/term.h"

namespace example {

using namespace shellmatch;

/// |Dphi n1 - s n2|^2 vanishes where phi carries the unit normals of the reference to s times those of the template:
/// with s = 1, as the theory of Kirchhoff and Love supposes of a thin shell.
template <int Dim>
struct NormalAlignment : BandTerm<Dim> {
  static constexpr TermInfo info{
      .name = "normal_alignment",
      .meaning = "normals are carried to normals",
      .weight = {"normal_alignment_weight",
                 0,
                 {.min = 0, .meaning = "factor on the alignment of normals; 0 switches it off"}},
      .scaled = [](double factor, const TermScales& s) { return factor * s.delta; }};
  static constexpr std::array<TermOption, 1> own{
      {{"normal_stretch", 1, {.min = 0, .meaning = "s: length of the carried normals"}}}};
  using Density = SquareDensity<Dim>;
  using Reads = DependsOn<Dphi, TargetNormal, ReferenceNormal, OwnOptions>;

  template <class T, class P>
  constexpr SmallVec<T, Dim> operator()(const SmallMat<T, Dim>& dphi, const SmallVec<T, Dim>& normal,
                                        const SmallVec<P, Dim>& n1, const P* options) const {
    const auto carried = times(dphi, n1);
    const auto n2 = renormalised(normal);
    SmallVec<T, Dim> gap;
    for (int i = 0; i < Dim; ++i) gap[i] = carried[i] - options[0] * n2[i];
    return gap;
  }
};

}  // namespace example
