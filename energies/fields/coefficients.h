#pragma once
/// \file
/// The coefficients of both shapes that the terms read at one point x of the domain.
///
/// Notation of the paper: d1, n1 and the root of C(S1) at x in the reference frame; d2, n2 and N^{1/2} = C(S2)^{1/2} at
/// phi(x) in the deformed frame; Dphi maps the first frame to the second.

#include "energies/autodiff/jet.h"
#include "energies/autodiff/pack.h"
#include "energies/densities/small_matrix.h"

#include <cmath>

namespace shellmatch {

/// Coefficients of the reference shape at x. They do not depend on phi.
template <int Dim, class P>
struct ReferencePoint {
  P d1;                 ///< signed distance to M1
  SmallVec<P, Dim> n1;  ///< unit normal
  SmallSym<P, Dim> r1;  ///< P1 C(S1)^{-1/2} P1; S1 for terms that read shape operators
  static constexpr int size = 1 + Dim + n_symmetric<Dim>;
};

/// Coefficients of the template shape at phi(x).
template <int Dim, class T>
struct TargetPoint {
  T d2;                   ///< signed distance to M2
  SmallVec<T, Dim> n2;    ///< interpolated normal, not of unit length
  SmallSym<T, Dim> root;  ///< C(S2)^{1/2}; S2 for terms that read shape operators
  static constexpr int size = 1 + Dim + n_symmetric<Dim>;
};

/// Smallest length by which an interpolated normal is divided. Shorter normals occur only near the medial axis, where
/// they may vanish.
inline constexpr double least_normal_length = 1e-2;

/// The vector n divided by max(|n|, least_normal_length). Interpolated normals are shorter than 1 where the surface
/// bends; unscaled, they would cost energy even on identical shapes.
template <class T, int Dim>
constexpr SmallVec<T, Dim> renormalised(const SmallVec<T, Dim>& n) {
  using autodiff::max_of;
  using std::sqrt;
  const T scale = 1.0 / sqrt(max_of(dot(n, n), T(least_normal_length * least_normal_length)));
  SmallVec<T, Dim> r;
  for (int i = 0; i < Dim; ++i) r[i] = n[i] * scale;
  return r;
}

}  // namespace shellmatch
