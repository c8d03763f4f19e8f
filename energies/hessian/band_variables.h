#pragma once
/// \file
/// The variables in which Newton's model of the band is made at a quadrature point, and how they depend on the degrees
/// of freedom of the element. In few variables few modes are added to the element's matrix, which is what its time is.

#include "energies/compiled/compiled_term.h"

#include <array>
#include <span>

namespace shellmatch {

/// X_ij = t2_i . Dphi t1_j in tangent frames of both shapes, then phi: all that tangential terms depend on.
template <int Dim>
struct TangentVariables {
  static constexpr int n = BandModelPoint<Dim>::n_tangent, n_dphi = n - Dim;
  static void add(const BandCode<Dim>& code, const BandModelPoint<Dim>& at, double weight, const double* own,
                  SquarePack<n>& h) {
    code.add_in_tangent(at, weight, own, h);
  }
  /// The change of Dphi along a direction of the variables, the first `First` entries of which are 0.
  template <int First>
  [[gnu::always_inline]] static void dphi_of(const BandModelPoint<Dim>& at,
                                             const std::array<autodiff::Pack, n>& direction,
                                             std::array<std::array<autodiff::Pack, Dim>, Dim>& dphi) {
    for (int v = First; v < n_dphi; ++v) {
      const int i = v / (Dim - 1), j = v % (Dim - 1);
      for (int a = 0; a < Dim; ++a) {
        const autodiff::Pack along = direction[v] * at.t2[i][a];
        for (int d = 0; d < Dim; ++d) dphi[a][d] += along * at.t1[j][d];
      }
    }
  }
};

/// The entries of Dphi in row order, then phi.
template <int Dim>
struct AllVariables {
  static constexpr int n = BandModelPoint<Dim>::n_all, n_dphi = n - Dim;
  static void add(const BandCode<Dim>& code, const BandModelPoint<Dim>& at, double weight, const double* own,
                  SquarePack<n>& h) {
    code.add_in_all(at, weight, own, h);
  }
  template <int First>
  static void dphi_of(const BandModelPoint<Dim>&, const std::array<autodiff::Pack, n>& direction,
                      std::array<std::array<autodiff::Pack, Dim>, Dim>& dphi) {
    for (int i = First; i < Dim * Dim; ++i) dphi[i / Dim][i % Dim] = direction[i];
  }
};

}  // namespace shellmatch
