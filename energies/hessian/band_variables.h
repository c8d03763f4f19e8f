#pragma once
/// \file
/// The variables in which Newton's model of the band is made at a quadrature point, and how they depend on the degrees of
/// freedom of the element. In few variables few modes are added to the element's matrix, which is what its time is.

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
  /// The change of Dphi along a direction of the variables.
  static void dphi_of(const BandModelPoint<Dim>& at, const std::array<autodiff::Pack, n>& direction,
                      std::array<std::array<autodiff::Pack, Dim>, Dim>& dphi) {
    for (int i = 0; i < Dim - 1; ++i)
      for (int j = 0; j < Dim - 1; ++j)
        for (int a = 0; a < Dim; ++a)
          for (int d = 0; d < Dim; ++d) dphi[a][d] += direction[i * (Dim - 1) + j] * at.t2[i][a] * at.t1[j][d];
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
  static void dphi_of(const BandModelPoint<Dim>&, const std::array<autodiff::Pack, n>& direction,
                      std::array<std::array<autodiff::Pack, Dim>, Dim>& dphi) {
    for (int i = 0; i < Dim * Dim; ++i) dphi[i / Dim][i % Dim] = direction[i];
  }
};

}  // namespace shellmatch
