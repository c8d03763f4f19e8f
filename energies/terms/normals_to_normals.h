#pragma once
/// \file

#include "energies/densities/square.h"
#include "energies/terms/term.h"

namespace shellmatch {

/// |Dphi n1 - s n2|^2 with an option s: unit normals of the reference become normals of length s of the template.
template <int Dim>
struct NormalsToNormals : BandTerm<Dim> {
  static constexpr TermInfo info{
      .name = "normals",
      .meaning = "normals are carried onto normals",
      .weight = {"normals_weight", 0, {.min = 0, .meaning = "factor on the normals' term; 0 switches it off"}},
      .scaled = [](double factor, const TermScales& s) { return factor * s.delta; }};
  static constexpr std::array<TermOption, 1> own{
      {{"normals_length", 1, {.min = 0, .meaning = "length that unit normals are carried to"}}}};
  using Density = SquareDensity<Dim>;

  template <class T, class P>
  static constexpr SmallVec<T, Dim> argument(const TargetPoint<Dim, T>& y, const SmallMat<T, Dim>& dphi,
                                             const ReferencePoint<Dim, P>& x, const Material<P>& c) {
    const auto carried = times(dphi, x.n1);
    const auto n2 = renormalised(y.n2);
    SmallVec<T, Dim> gap;
    for (int i = 0; i < Dim; ++i) gap[i] = carried[i] - c.own[0] * n2[i];
    return gap;
  }
};

}  // namespace shellmatch
