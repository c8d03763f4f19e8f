// The element costs are cost functors of Ceres: its automatic differentiation and its gradient checker take them
// as they are, and the checker rejects a wrong one.

#include "energies/element_cost.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/gradient_checker.h>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

// Claims derivatives that are one per cent too large.
class Exaggerated : public ceres::CostFunction {
 public:
  explicit Exaggerated(const ceres::CostFunction& right) : right_(right) {
    set_num_residuals(right.num_residuals());
    *mutable_parameter_block_sizes() = right.parameter_block_sizes();
  }
  bool Evaluate(const double* const* x, double* residuals, double** jacobians) const override {
    if (!right_.Evaluate(x, residuals, jacobians)) return false;
    if (jacobians && jacobians[0])
      for (int i = 0; i < parameter_block_sizes()[0]; ++i) jacobians[0][i] *= 1.01;
    return true;
  }

 private:
  const ceres::CostFunction& right_;
};

bool accepted(const ceres::CostFunction& cost, const std::vector<double>& dofs) {
  const std::vector<const ceres::Manifold*>* no_manifolds = nullptr;
  const ceres::GradientChecker checker(&cost, no_manifolds, ceres::NumericDiffOptions());
  const double* block = dofs.data();
  // No results: they hold Eigen matrices, which Ceres' library, built for another processor, allocates differently.
  return checker.Probe(&block, 1e-3, nullptr);
}

template <class Functor>
void check(Functor* functor, const std::vector<double>& dofs) {
  const ceres::AutoDiffCostFunction<Functor, 1, Functor::n_dofs> cost(functor);  // takes the functor over
  EXPECT_TRUE(accepted(cost, dofs));
  EXPECT_FALSE(accepted(Exaggerated(cost), dofs));
}

template <int Dim>
void check_terms() {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  // No kinks in the way of Ceres' steps, and a deformation for which no derivative is nearly zero.
  const Problem<Dim> p(grid, exact_fields<Dim>(grid, sphere<Dim>(0.28)), linear_fields<Dim>(grid));
  const auto phi = deformed<Dim>(grid, 0.05, 3);
  const Band<Dim>& band = p.energy.band();
  const std::size_t batch = band.batches().size() / 2;
  const Element<Dim>& element = p.unknowns.elements()[band.batches()[batch].element[1]];
  std::vector<double> dofs;
  for (const Index node : element.nodes) dofs.insert(dofs.end(), phi[node].begin(), phi[node].end());

  const Lame<double> lame{1, 1};
  const auto& shape = p.energy.shape();
  const double weight = std::pow(element.side, -Dim);  // so that the derivatives are of order 1
  check(new BandElementCost<Match, Dim>(band, batch, 1, p.unknowns.elements(), shape, p.target, weight, lame), dofs);
  check(new BandElementCost<Bending, Dim>(band, batch, 1, p.unknowns.elements(), shape, p.target, weight, lame), dofs);
  check(new VolumeElementCost<FullVolume, Dim>(element.side, shape, weight, lame), dofs);
}

TEST(CeresChecker, TakesElementCostsInThePlane) { check_terms<2>(); }
TEST(CeresChecker, TakesElementCostsInSpace) { check_terms<3>(); }

}  // namespace
}  // namespace shellmatch
