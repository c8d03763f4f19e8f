// The element costs are cost functors of Ceres: its automatic and its numeric differentiation take them
// as they are and agree, and a wrong derivative is found. (Ceres' GradientChecker itself hands Eigen matrices to a
// library that was built for another processor, which aligns them differently.)

#include "energies/element_cost.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/numeric_diff_cost_function.h>
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

// Do the derivatives that `cost` claims agree with Ceres' numeric differentiation of the functor? Compared to the
// largest of them, as single ones may vanish.
template <class Functor>
bool accepted(const ceres::CostFunction& cost, const Functor& functor, const std::vector<double>& dofs) {
  const ceres::NumericDiffCostFunction<Functor, ceres::CENTRAL, 1, Functor::n_dofs> numeric(new Functor(functor));
  Eigen::Matrix<double, Functor::n_dofs, 1> claimed, differences;
  const double* block = dofs.data();
  double value = 0, numeric_value = 0;
  double *j1 = claimed.data(), *j2 = differences.data();
  if (!cost.Evaluate(&block, &value, &j1) || !numeric.Evaluate(&block, &numeric_value, &j2)) return false;
  if (std::abs(value - numeric_value) > 1e-12 * std::abs(value)) return false;
  return (claimed - differences).cwiseAbs().maxCoeff() < 1e-4 * differences.cwiseAbs().maxCoeff();
}

template <class Functor>
void check(Functor* functor, const std::vector<double>& dofs) {
  const ceres::AutoDiffCostFunction<Functor, 1, Functor::n_dofs> cost(functor);  // takes the functor over
  EXPECT_TRUE(accepted(cost, *functor, dofs));
  EXPECT_FALSE(accepted(Exaggerated(cost), *functor, dofs));
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
