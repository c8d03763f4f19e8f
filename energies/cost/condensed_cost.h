#pragma once
/// \file
/// A cost function of one element by the unknowns of the grid, for ceres::Problem: its parameter blocks are the unknown
/// nodes on which the element depends. Hanging corners are interpolated and fixed ones stay.

#include "energies/cost/cost_function.h"
#include "energies/elements/element_unknowns.h"

#include <array>
#include <utility>
#include <vector>

namespace shellmatch {

template <int Dim>
class CondensedCost final : public ceres::CostFunction {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim;

  /// \param phi  nodal positions, of which those of fixed nodes count
  CondensedCost(ElementCostFunction element, const Unknowns<Dim>& unknowns, std::size_t number,
                std::span<const Vec<Dim>> phi)
      : element_(std::move(element)), unknowns_(element_unknowns(unknowns, number)) {
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int k = 0; k < Dim; ++k) fixed_[c * Dim + k] = phi[unknowns.elements()[number].nodes[c]][k];
    for (int i = 0; i < unknowns_.size(); ++i)
      for (const auto& [corner, weight] : unknowns_.corners_of(i))
        for (int k = 0; k < Dim; ++k)
          fixed_[corner * Dim + k] -= static_cast<double>(weight) * phi[unknowns.nodes()[unknowns_[i]]][k];
    set_num_residuals(element_->num_residuals());
    mutable_parameter_block_sizes()->assign(static_cast<std::size_t>(unknowns_.size()), Dim);
  }

  /// The unknown nodes in the order of the parameter blocks, by their place in Unknowns::nodes().
  const ElementUnknowns<Dim, Index>& unknowns() const { return unknowns_; }

  bool Evaluate(double const* const* nodes, double* residuals, double** jacobians) const override {
    std::array<double, n_dofs> dofs = fixed_;
    for (int i = 0; i < unknowns_.size(); ++i)
      for (const auto& [corner, weight] : unknowns_.corners_of(i))
        for (int k = 0; k < Dim; ++k) dofs[corner * Dim + k] += static_cast<double>(weight) * nodes[i][k];
    const double* const block[] = {dofs.data()};
    if (jacobians == nullptr) return element_->Evaluate(block, residuals, nullptr);
    std::vector<double> by_dofs(static_cast<std::size_t>(num_residuals() * n_dofs));
    double* of_block[] = {by_dofs.data()};
    if (!element_->Evaluate(block, residuals, of_block)) return false;
    for (int i = 0; i < unknowns_.size(); ++i) {
      if (jacobians[i] == nullptr) continue;
      for (int r = 0; r < num_residuals(); ++r)
        for (int k = 0; k < Dim; ++k) {
          double sum = 0;
          for (const auto& [corner, weight] : unknowns_.corners_of(i))
            sum += static_cast<double>(weight) * by_dofs[static_cast<std::size_t>(r * n_dofs + corner * Dim + k)];
          jacobians[i][r * Dim + k] = sum;
        }
    }
    return true;
  }

 private:
  ElementCostFunction element_;
  ElementUnknowns<Dim, Index> unknowns_;
  std::array<double, n_dofs> fixed_;  ///< positions of the corners with all unknowns at 0
};

}  // namespace shellmatch
