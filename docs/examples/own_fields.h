#pragma once
/// \file
/// Two terms that read fields of the user's own, and are residuals of cells: the example own_fields.

#include "energies/densities/material.h"
#include "energies/terms/term.h"

namespace example {

using namespace shellmatch;

/// |Dphi - R|^2 with a rotation R that lags behind phi, the polar factor of an earlier Dphi: as rigid as possible
/// (Sorkine and Alexa 2007).
template <int Dim>
struct NearRotation : CellTerm<Dim> {
  struct Rotation : OwnField<Dim * Dim> {};  ///< its rows
  static constexpr TermInfo info{.name = "near_rotation"};
  using Density = SquareDensity<Dim * Dim>;
  using Reads = DependsOn<Dphi, Rotation>;

  template <class T, class P>
  constexpr SmallVec<T, Dim * Dim> operator()(const SmallMat<T, Dim>& dphi, const SmallVec<P, Dim * Dim>& r) const {
    SmallVec<T, Dim * Dim> gap;
    for (int i = 0; i < Dim * Dim; ++i) gap[i] = dphi.v[i] - r[i];
    return gap;
  }
};

/// w |phi - phi0|^2 with a map phi0 that is known at the nodes, as from an earlier registration, and a weight w of
/// cells.
template <int Dim>
struct NearMap : CellTerm<Dim> {
  struct KnownMap : OwnField<Dim> {};
  struct RootOfWeight : OwnField<1> {};
  static constexpr TermInfo info{.name = "near_map"};
  using Density = SquareDensity<Dim>;
  using Reads = DependsOn<Phi, KnownMap, RootOfWeight>;

  template <class T, class P>
  constexpr SmallVec<T, Dim> operator()(const SmallVec<T, Dim>& phi, const SmallVec<P, Dim>& phi0,
                                        const SmallVec<P, 1>& root) const {
    SmallVec<T, Dim> gap;
    for (int i = 0; i < Dim; ++i) gap[i] = root[0] * (phi[i] - phi0[i]);
    return gap;
  }
};

}  // namespace example
