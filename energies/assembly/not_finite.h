#pragma once
/// \file
/// Finds what makes an energy or its gradient infinite or NaN. It is slow and asked only where a sum is not finite.

#include "energies/assembly/matching_energy.h"

#include <optional>
#include <span>
#include <string>

namespace shellmatch {

/// The first element, in the order of Unknowns::elements(), where a term is not finite.
template <int Dim>
struct NotFinite {
  std::string what;  ///< "value", "gradient" or "Newton model"
  std::string term;  ///< its name in reports
  std::size_t element = 0;
  double side = 0;                     ///< of the cell, in sides of the domain
  Vec<Dim> corner = Vec<Dim>::Zero();  ///< lower one of the cell, reference frame
  std::optional<Vec<Dim>> point;       ///< quadrature point, reference frame; none for terms of corners or of pairs
};

/// Looks at every term with a positive weight, element after element, by its functor. \return nothing where all are
/// finite, so that only their sum is not
template <int Dim>
std::optional<NotFinite<Dim>> find_not_finite(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns,
                                              std::span<const Vec<Dim>> phi, const TermValues& weights);

/// "the gradient of the term membrane is not finite in the cell of side 0.0625 at (0.25, 0.5), at the point (0.26,
/// 0.51)"
template <int Dim>
std::string not_finite_text(const NotFinite<Dim>& found);

}  // namespace shellmatch
