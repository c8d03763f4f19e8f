#pragma once
/// \file
/// The energy on single elements, evaluated by the terms' functors (energies/compiled/element_cost.h): values, and
/// derivatives by ceres::Jet. It shares the terms with the assembly but none of its code; derivative checks compare
/// both.

#include "energies/assembly/matching_energy.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class ElementOracle {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;
  using Dofs = std::array<double, n_dofs>;  ///< positions of the corners, Dim components each

  /// Both arguments must outlive this object.
  ElementOracle(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns);

  /// Weighted sum of the terms on element e of Unknowns::elements(); NaN where it cannot be evaluated.
  double value(const TermValues& weights, std::size_t e, const Dofs& dofs) const;
  /// The same with its derivative by the entries of `dofs`.
  double gradient(const TermValues& weights, std::size_t e, const Dofs& dofs, Dofs& gradient) const;

  /// The share of quadrature point q in the value of one term with this weight on element e, and its derivative; nothing
  /// where the term does not act at that point, or acts at none.
  std::optional<double> gradient_at_point(std::size_t term, double weight, std::size_t e, const Dofs& dofs, std::size_t q,
                                          Dofs& gradient) const;

  /// Numbers of the element's quadrature points in the band, where the target is evaluated.
  std::vector<int> band_points(std::size_t e) const;

  Dofs dofs_of(std::size_t e, std::span<const Vec<Dim>> phi) const;
  /// phi at a quadrature point of the element.
  Vec<Dim> position(const Dofs& dofs, int point) const;

  /// Size of the terms' derivatives on element e for strains and mismatches of order 1. Derivatives that are much
  /// smaller are dominated by the rounding errors of a cancellation.
  double natural_size(const TermValues& weights, std::size_t e) const;

 private:
  ElementFields<Dim>& fields_of(std::size_t e) const;
  // Calls body(pairs, weight) for the terms of pairs with a positive weight.
  template <class Body>
  void for_each_pair_term(const TermValues& weights, Body&& body) const {
    const auto terms = energy_->pair_terms();
    for (std::size_t t = 0; t < terms.size(); ++t)
      if (const double weight = weights[energy_->terms().size() + t]; weight > 0) body(terms[t].pairs, weight);
  }

  const MatchingEnergy<Dim>* energy_;
  std::span<const Element<Dim>> elements_;
  std::vector<Index> lane_of_;  ///< batch times lanes plus lane within the band, or no_index; by element
};

}  // namespace shellmatch
