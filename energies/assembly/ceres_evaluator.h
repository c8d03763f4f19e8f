#pragma once
/// \file
/// The energy by ceres::CostFunctions of single elements (energies/cost/element_cost.h): values, and derivatives by
/// ceres::Jet. It shares the terms' functors with the compiled assembly but none of its code: with `energy.evaluator:
/// ceres` it takes that one's place, and derivative checks compare both.

#include "energies/assembly/matching_energy.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class CeresEvaluator {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;
  using Dofs = std::array<double, n_dofs>;  ///< positions of the corners, Dim components each

  /// `energy` must outlive this object.
  explicit CeresEvaluator(const MatchingEnergy<Dim>& energy) : energy_(&energy) {}

  /// Weighted sum of the terms on element e; NaN where it cannot be evaluated.
  double value(const TermValues& weights, std::size_t e, const Dofs& dofs) const;
  /// The same with its derivative by the entries of `dofs`.
  double gradient(const TermValues& weights, std::size_t e, const Dofs& dofs, Dofs& gradient) const;

  /// The weighted value of each term on element e is added to `values`, and the derivative of their sum by the entries
  /// of `dofs` to `gradient`, if not null. False where a term cannot be evaluated.
  bool add(const TermValues& weights, std::size_t e, const Dofs& dofs, double* values, double* gradient) const;

  /// The share of quadrature point q in the value of one term with this weight on element e, and its derivative;
  /// nothing where the term does not act at that point, or acts at none.
  std::optional<double> gradient_at_point(std::size_t term, double weight, std::size_t e, const Dofs& dofs,
                                          std::size_t q, Dofs& gradient) const;

  /// What term t of MatchingEnergy::terms() reads on element e. Scratch of this thread, valid until its next call.
  ElementFields<Dim>& fields_of(std::size_t t, std::size_t e) const;

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

  const MatchingEnergy<Dim>* energy_;
};

}  // namespace shellmatch
