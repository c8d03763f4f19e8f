#pragma once
/// \file
/// The energy element by element the slow way, from the cost functors of energies/assembly/element_cost.h: their values, and
/// their derivatives by ceres::Jet. Shares the integrands with the assembly and nothing of its code: what derivative
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
  ElementOracle(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns, const GeometryField<Dim>& target,
                const EnergyOptions& options);

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
  template <class T>
  T sum(const TermValues& weights, std::size_t e, const std::array<T, n_dofs>& dofs) const;

  const MatchingEnergy<Dim>* energy_;
  std::span<const Element<Dim>> elements_;
  const GeometryField<Dim>* target_;
  EnergyOptions options_;
  std::vector<Index> place_;  ///< batch times lanes plus lane within the band, or no_index
};

}  // namespace shellmatch
