#pragma once
/// \file
/// The energy as problems of Ceres: a first-order function of the unknowns, and the terms that are squares as
/// residuals.

#include "energies/assembly/matching_energy.h"

#include <ceres/first_order_function.h>
#include <ceres/problem.h>

#include <span>
#include <vector>

namespace shellmatch {

/// For ceres::GradientProblem, which takes it over. `energy` and `unknowns` must outlive it.
template <int Dim>
class EnergyFunction final : public ceres::FirstOrderFunction {
 public:
  /// \param phi  nodal positions, of which those of fixed nodes count
  EnergyFunction(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns, TermValues weights,
                 std::vector<Vec<Dim>> phi);
  /// False where a term cannot be evaluated.
  bool Evaluate(const double* x, double* cost, double* gradient) const override;
  int NumParameters() const override { return static_cast<int>(unknowns_->size()); }

 private:
  const MatchingEnergy<Dim>* energy_;
  const Unknowns<Dim>* unknowns_;
  TermValues weights_;
  mutable std::vector<Vec<Dim>> phi_;
  mutable TermValues values_;
};

/// Adds the terms of positive weight that are squares, and those of pairs with their losses, as residual blocks over
/// the unknown nodes, whose positions are at x. The problem's cost is then the sum of these terms. \param phi  nodal
/// positions, of which those of fixed nodes count \return the names of the terms of positive weight that are no
/// squares, and left out \pre x.size() == unknowns.size(); x and `energy` outlive the problem, and the band's weights
/// do not change
template <int Dim>
std::vector<std::string> add_residuals(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns,
                                       const TermValues& weights, std::span<const Vec<Dim>> phi, std::span<double> x,
                                       ceres::Problem& problem);

extern template class EnergyFunction<2>;
extern template class EnergyFunction<3>;

}  // namespace shellmatch
