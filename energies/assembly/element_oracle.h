#pragma once
/// \file
/// The energy element by element without compiled code, from the terms' own functors (energies/compiled/element_cost.h):
/// values, and derivatives by ceres::Jet. It shares the terms with the assembly and nothing of its code: what derivative
/// checks hold the assembly against.

#include "energies/assembly/matching_energy.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class ElementOracle {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;
  using Dofs = std::array<double, n_dofs>;  ///< corner after corner, Dim components each

  /// All must outlive it.
  ElementOracle(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns);

  /// Weighted sum of the terms on element e of Unknowns::elements(); NaN where it cannot be evaluated.
  double value(const TermValues& weights, std::size_t e, const Dofs& dofs) const;
  /// The same with its derivative.
  double gradient(const TermValues& weights, std::size_t e, const Dofs& dofs, Dofs& gradient) const;

  /// Quadrature points of the element at which the target is read: those within the band.
  std::vector<int> band_points(std::size_t e) const;

  Dofs dofs_of(std::size_t e, std::span<const Vec<Dim>> phi) const;
  /// phi at a quadrature point.
  Vec<Dim> position(const Dofs& dofs, int point) const;

  /// Size of the derivatives that these terms would have on the element under strains and mismatches of order 1:
  /// derivatives that are far smaller are the rest of a cancellation.
  double natural_size(const TermValues& weights, std::size_t e) const;

 private:
  ElementFields<Dim>& fields_of(std::size_t e) const;

  const MatchingEnergy<Dim>* energy_;
  std::span<const Element<Dim>> elements_;
  std::vector<Index> lane_of_;  ///< batch times lanes plus lane within the band, or no_index
};

}  // namespace shellmatch
