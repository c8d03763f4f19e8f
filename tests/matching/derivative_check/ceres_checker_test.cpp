// The element costs are cost functors of Ceres: its automatic differentiation takes them as they are, its checker
// accepts what comes of that, and a wrong derivative is found.

#include "matching/derivative_check/ceres_checker.h"

#include "energies/cost/element_cost.h"
#include "energies/terms/list.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <ceres/autodiff_cost_function.h>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

template <class Functor>
void check(const Functor& functor, const std::vector<double>& dofs, double side) {
  constexpr int n = Functor::n_dofs;
  const ceres::AutoDiffCostFunction<Functor, 1, n> cost(new Functor(functor));  // takes the functor over
  for (const double exaggeration : {1.0, 1.001}) {
    const SmallFunction function = [&](std::span<const double> x, double& value, std::span<double> gradient) {
      const double* block = x.data();
      double* jacobian = gradient.data();
      if (!cost.Evaluate(&block, &value, gradient.empty() ? nullptr : &jacobian)) return false;
      for (double& g : gradient) g *= exaggeration;
      return true;
    };
    const CeresVerdict verdict = check_with_ceres(function, dofs, 1e-4 * side, 1e-4);
    EXPECT_EQ(verdict.passed, exaggeration == 1.0);
    EXPECT_GT(verdict.worst_relative_error, exaggeration == 1.0 ? 0 : 0.9e-3);
  }
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

  const ElementFields<Dim> fields(element, p.geometry, ProblemOptions{}.sigma_over_h * grid.finest_side(),
                                  p.energy.shape());
  const double weight = std::pow(element.side, -Dim);  // so that the derivatives are of order 1
  check(ElementCost<Match<Dim>>(fields, weight, 1, 1), dofs, element.side);
  check(ElementCost<Membrane<Dim>>(fields, weight, 1, 1), dofs, element.side);
  check(ElementCost<Bending<Dim>>(fields, weight, 1, 1), dofs, element.side);
  check(ElementCost<FullVolume<Dim>>(fields, weight, 1, 1), dofs, element.side);
}

TEST(CeresChecker, AcceptsElementCostsInThePlane) { check_terms<2>(); }
TEST(CeresChecker, AcceptsElementCostsInSpace) { check_terms<3>(); }

TEST(CeresChecker, AFunctionThatCannotBeEvaluatedDoesNotPass) {
  const SmallFunction nowhere = [](std::span<const double>, double&, std::span<double>) { return false; };
  EXPECT_FALSE(check_with_ceres(nowhere, std::vector<double>{1, 2, 3}, 1e-4, 1e-4).passed);
}

}  // namespace
}  // namespace shellmatch
