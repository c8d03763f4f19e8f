#pragma once
/// \file
/// Bounds of det Dphi on eight elements, by its Bernstein coefficients (energies/densities/bernstein.h).

#include "energies/elements/element_batch.h"

namespace shellmatch {

/// Smallest Bernstein coefficient of det Dphi on each element: det Dphi is nowhere smaller.
template <int Dim>
autodiff::Pack least_determinant(const ElementBatch<Dim>& batch);

/// A lower bound of all Bernstein coefficients of det Dphi on each element, at a third of their cost; exact where phi
/// is affine. NaN where a position is.
template <int Dim>
autodiff::Pack determinant_bound(const ElementBatch<Dim>& batch);

/// Upper bound of the change of the Bernstein coefficients of det Dphi on an element where the entries of Dphi have
/// magnitudes of at most `largest` and change by at most `change`: a determinant is a sum of Dim! products.
template <int Dim>
autodiff::Pack determinant_change(autodiff::Pack largest, autodiff::Pack change) {
  const autodiff::Pack after = largest + change;
  if constexpr (Dim == 2) return 2.0 * (after * after - largest * largest);
  else return 6.0 * (after * after * after - largest * largest * largest);
}

}  // namespace shellmatch
