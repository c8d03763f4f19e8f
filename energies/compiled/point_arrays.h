#pragma once
/// \file
/// What the band terms read at eight quadrature points and what they give back, as flat arrays of packs: the inputs of
/// compiled code (energies/autodiff/compiled.h).

#include "energies/autodiff/pack.h"
#include "energies/fields/coefficients.h"

#include <array>

namespace shellmatch {

template <int Dim>
struct PointArrays {
  static constexpr int n_target = TargetPoint<Dim, double>::size;
  static constexpr int n_reference = ReferencePoint<Dim, double>::size;
  static constexpr int n_without_phi = n_target + Dim * Dim, n_active = n_without_phi + Dim;
  static constexpr int n_passive = n_reference + 2;

  std::array<autodiff::Pack, n_active> active;    ///< d2, n2, root; Dphi by rows; phi where a term reads it
  std::array<autodiff::Pack, n_passive> passive;  ///< d1, n1, r1; lambda, mu
  std::array<autodiff::Pack, n_active> adjoint;   ///< derivative by the active inputs, weighted
  std::array<std::array<autodiff::Pack, n_target>, Dim> derivative;  ///< of d2, n2, root by each coordinate of phi
  const autodiff::Pack* own_fields = nullptr;                        ///< of the term that is evaluated
};

}  // namespace shellmatch
