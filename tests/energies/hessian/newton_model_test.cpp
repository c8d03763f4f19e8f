// What Newton's method relies on: the band's part of the model near a solution, and the restraint of steps that
// would fold cells.

#include "energies/hessian/energy_hessian.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

using namespace test;

// On one shape, both as reference and as template, the identity has no residual and no stress: there the model is
// the second derivative itself, with what n2 and the template's curvature owe to phi.
template <int Dim>
void check_band_part(Term term) {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const auto fields = exact_fields<Dim>(grid, sphere<Dim>(0.28));
  const Problem<Dim> p(grid, fields, fields);
  const auto identity = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
  const TermValues weights = only(term);
  EnergyHessian<Dim> hessian(p.energy, p.unknowns, p.target, {});
  hessian.assemble(identity, weights);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<double> u(p.unknowns.size()), hu(u.size()), x(u.size());
  auto phi = identity;
  for (int trial = 0; trial < 3; ++trial) {
    for (double& ui : u) ui = normal(random);
    hessian.apply(u, hu);
    double model = 0;
    for (std::size_t i = 0; i < u.size(); ++i) model += u[i] * hu[i];
    const double t = 1e-6;  // moves no quadrature point into another cell, where the fields have a kink
    const auto value = [&](double step) {
      p.unknowns.restrict_to(identity, x);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += step * u[i];
      p.unknowns.expand(x, phi);
      return p.value(phi, term);
    };
    const double exact = (value(t) - 2 * value(0) + value(-t)) / (t * t);
    EXPECT_NEAR(model, exact, 1e-3 * exact) << term_names[static_cast<std::size_t>(term)];
  }
}
template <int Dim>
void check_band_parts() {
  for (const Term term : {"match"_term, "membrane"_term, "bending"_term}) check_band_part<Dim>(term);
}

TEST(NewtonModel, IsTheSecondDerivativeWithoutStress) {
  check_band_parts<2>();
  check_band_parts<3>();
}

// A step that turns a cell over is resisted, as far as it differs within a cell; with time that is forgotten.
template <int Dim>
void check_restraint() {
  const Octree<Dim> grid(3);
  const Problem<Dim> p(grid, exact_fields<Dim>(grid, sphere<Dim>(0.28)), exact_fields<Dim>(grid, sphere<Dim>(0.28)));
  const auto identity = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
  TermValues weights = only("volume"_term);
  weights["barrier"_term] = 1;
  EnergyOptions options;
  options.terms.factor("barrier"_term) = 1;
  EnergyHessian<Dim> hessian(p.energy, p.unknowns, p.target, options);
  hessian.assemble(identity, weights);
  std::vector<double> fold(p.unknowns.size(), 0.0), shift(fold.size(), 0.0), small(fold.size(), 0.0), product(fold.size());
  for (std::size_t i = 0; i < p.unknowns.nodes().size(); ++i) shift[Dim * i] = 1;
  std::size_t middle = 0;
  for (std::size_t i = 0; i < p.unknowns.nodes().size(); ++i)
    if ((grid.node_position(p.unknowns.nodes()[i]) - Vec<Dim>::Constant(0.5)).norm() < 1e-9) middle = i;
  fold[Dim * middle] = 0.2;  // more than a cell's side
  small[Dim * middle] = 0.02;
  const auto energy_of = [&](const std::vector<double>& x) {
    hessian.apply(x, product);
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * product[i];
    return sum;
  };
  const double fold_before = energy_of(fold), shift_before = energy_of(shift);
  EXPECT_FALSE(hessian.restrain(identity, small));
  EXPECT_EQ(energy_of(fold), fold_before);
  EXPECT_TRUE(hessian.restrain(identity, fold));
  const double once = energy_of(fold);
  EXPECT_GT(once, 1.4 * fold_before);
  EXPECT_NEAR(energy_of(shift), shift_before, 1e-5);
  EXPECT_TRUE(hessian.restrain(identity, fold));
  EXPECT_GT(energy_of(fold), 3 * once);
  hessian.assemble(identity, weights);
  EXPECT_LT(energy_of(fold), once * 8);
  EXPECT_GT(energy_of(fold), fold_before);
  for (int i = 0; i < 80; ++i) hessian.assemble(identity, weights);
  EXPECT_NEAR(energy_of(fold), fold_before, 1e-6 * fold_before);
  // Where folds cost nothing, nothing is to be restrained.
  hessian.assemble(identity, only("volume"_term));
  EXPECT_FALSE(hessian.restrain(identity, fold));
}
TEST(NewtonModel, RestrainsStepsThatFold) {
  check_restraint<2>();
  check_restraint<3>();
}

}  // namespace
}  // namespace shellmatch
