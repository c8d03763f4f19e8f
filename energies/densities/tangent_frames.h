#pragma once
/// \file
/// Orthonormal frames of the tangent planes of both shapes, eight points at a time.

#include "energies/autodiff/pack.h"

#include <array>

namespace shellmatch {

/// Vectors t_1, ..., t_{Dim-1} that span a tangent plane, in packs of eight points.
template <int Dim>
using TangentBasis = std::array<std::array<autodiff::Pack, Dim>, Dim - 1>;

/// Orthonormal basis of the plane (line) perpendicular to a unit vector; with the vector itself last, of one
/// handedness everywhere. Duff et al., 'Building an orthonormal basis, revisited', JCGT 6(1), 2017.
template <int Dim>
TangentBasis<Dim> tangent_basis(const std::array<autodiff::Pack, Dim>& n) {
  using autodiff::Pack;
  if constexpr (Dim == 2) {
    return {{{n[1], -n[0]}}};
  } else {
    const Pack one = Pack{} + 1.0;
    const Pack sign = autodiff::where_greater(Pack{}, n[2], -one, one);
    const Pack a = -1.0 / (sign + n[2]);
    const Pack b = n[0] * n[1] * a;
    return {{{1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]}, {b, sign + n[1] * n[1] * a, -n[1]}}};
  }
}

}  // namespace shellmatch
