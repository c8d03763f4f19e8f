#pragma once
/// \file
/// The matching energy on one grid as a problem for the solvers. Energies and solvers meet here only.

#include "energies/hessian/energy_hessian.h"
#include "energies/assembly/matching_energy.h"
#include "solvers/objective.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace shellmatch {

template <int Dim>
class LevelProblem final : public SecondOrderObjective {
 public:
  /// \param phi nodal positions: those of fixed nodes are kept, the others overwritten by evaluate()
  /// \param mass lumped mass of each unknown node, in the order of unknowns.nodes()
  /// \param metric matrices of the metrics h1 and h1_band on the unknown nodes; null if neither is used
  LevelProblem(const Unknowns<Dim>& unknowns, const MatchingEnergy<Dim>& energy, EnergyHessian<Dim>& hessian,
               const TermValues& weights, std::span<const double> mass, std::vector<Vec<Dim>> phi,
               std::function<Eigen::SparseMatrix<double>(Metric)> metric = {});

  std::size_t size() const override { return unknowns_->size(); }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override;
  /// Evaluates value and gradient, which the next call of evaluate() returns if its x is the same. False as there; then
  /// term_values() are not defined.
  bool evaluate_ahead(std::span<const double> x);
  std::vector<std::string> term_names() const override;
  std::vector<double> term_values() const override { return {values_.begin(), values_.end()}; }
  std::span<const double> lumped_mass() const override { return mass_; }
  Eigen::SparseMatrix<double> metric_matrix(Metric metric) const override {
    return metric_ ? metric_(metric) : Eigen::SparseMatrix<double>();
  }

  void prepare_second_derivative(std::span<const double> x, std::span<const float> damping) override;
  void apply_second_derivative(std::span<const double> x, std::span<double> y) const override { hessian_.apply(x, y); }
  void precondition(std::span<const double> r, std::span<double> z) const override { hessian_.precondition(r, z); }

  std::string what_is_not_finite(std::span<const double> x) override;
  std::string what_of_model_is_not_finite(std::span<const double> x) override;

  /// The number of the grid's elements.
  std::size_t n_regions() const override { return unknowns_->elements().size(); }
  std::vector<RegionDamping> regions_beyond_model(std::span<const double> x, std::span<const double> d) override;
  void add_damping(std::span<const RegionDamping> regions) override;
  bool extend_model(std::span<const double> x, std::span<const double> d, std::span<double> gradient) override;
  void contract_step(std::span<const RegionDamping> regions, double share, std::span<double> d) override;

  /// The unknowns that belong to the nodal positions `phi`.
  std::vector<double> unknowns_of(const std::vector<Vec<Dim>>& phi) const;
  /// The nodal positions of the latest evaluation.
  const std::vector<Vec<Dim>>& last_positions() const { return phi_; }
  /// The nodal positions that belong to the unknowns `x`.
  std::vector<Vec<Dim>> positions(std::span<const double> x) const;

 private:
  const Unknowns<Dim>* unknowns_;
  const MatchingEnergy<Dim>* energy_;
  EnergyHessian<Dim>& hessian_;
  TermValues weights_, values_;
  std::vector<double> mass_;
  std::vector<Vec<Dim>> phi_;
  std::vector<double> x_ahead_, gradient_ahead_;  ///< empty but between evaluate_ahead() and evaluate()
  std::function<Eigen::SparseMatrix<double>(Metric)> metric_;
};

}  // namespace shellmatch
