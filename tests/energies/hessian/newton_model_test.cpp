// What Newton's method relies on: the band's part of the model near a solution, the margin that a step may use up
// before cells fold, and damping.

#include "energies/hessian/energy_hessian.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <string_view>
#include <utility>

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
  EnergyHessian<Dim> hessian(p.energy, p.unknowns);
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
    EXPECT_NEAR(model, exact, 1e-3 * exact) << term_names()[static_cast<std::size_t>(term)];
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

/// The undeformed domain, the unknowns' node in its middle, and steps by the unknowns.
template <int Dim>
struct Steps {
  const Octree<Dim> grid{3};
  const Problem<Dim> problem;
  const std::vector<Vec<Dim>> identity = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
  std::vector<double> fold, small,
      shift;  ///< the middle node moved by more than a cell's side, a little, and all nodes
  std::size_t middle = 0;
  mutable std::vector<double> product;

  explicit Steps(std::string_view volume)
      : problem(grid, exact_fields<Dim>(grid, sphere<Dim>(0.28)), exact_fields<Dim>(grid, sphere<Dim>(0.28)),
                with(volume)),
        fold(problem.unknowns.size(), 0.0),
        small(fold),
        shift(fold),
        product(fold) {
    for (std::size_t i = 0; i < problem.unknowns.nodes().size(); ++i) {
      shift[Dim * i] = 1;
      if ((grid.node_position(problem.unknowns.nodes()[i]) - Vec<Dim>::Constant(0.5)).norm() < 1e-9) middle = i;
    }
    fold[Dim * middle] = 0.2;
    small[Dim * middle] = 0.02;
  }
  static ProblemOptions with(std::string_view volume) {
    ProblemOptions o;
    o.energy.terms.model("volume"_term) = volume;
    return o;
  }
  /// x . H x
  double energy_of(const EnergyHessian<Dim>& hessian, const std::vector<double>& x) const {
    hessian.apply(x, product);
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * product[i];
    return sum;
  }
};

// A step that turns a cell over, or nearly so, is beyond the margin on this cell and no other.
template <int Dim>
void check_margins() {
  const Steps<Dim> steps("simplified");
  TermValues weights = only("volume"_term);
  weights["barrier"_term] = 1;
  EnergyHessian<Dim> hessian(steps.problem.energy, steps.problem.unknowns);
  hessian.assemble(steps.identity, weights);
  EXPECT_TRUE(hessian.elements_beyond_margin(steps.identity, steps.small).empty());
  EXPECT_TRUE(hessian.elements_beyond_margin(steps.identity, steps.shift).empty());
  const auto beyond = hessian.elements_beyond_margin(steps.identity, steps.fold);
  // Those in front of the node: by 0.2 of the side 1/8 their determinant falls below zero; behind it they are
  // stretched.
  EXPECT_EQ(beyond.size(), static_cast<std::size_t>(n_corners<Dim> / 2));
  const auto elements = steps.problem.unknowns.elements();
  double trace = 0;  // of the whole model, at one of the elements: they are all alike
  for (std::size_t i = 0; i < steps.fold.size(); ++i) {
    std::vector<double> unit(steps.fold.size(), 0.0);
    if (i / Dim != steps.middle) continue;
    unit[i] = 1;
    trace += steps.energy_of(hessian, unit);
  }
  for (const ElementDamping& one : beyond) {
    ASSERT_LT(one.element, elements.size());
    const auto& nodes = elements[one.element].nodes;
    const Index middle = steps.problem.unknowns.nodes()[steps.middle];
    EXPECT_NE(std::find(nodes.begin(), nodes.end(), middle), nodes.end());
    EXPECT_GT(elements[one.element].corner[0], 0.5 - 1e-9) << "in the step's direction";
    // As stiff as the element's own matrix: the traces of both are equal. The model's sum at an inner node, over the
    // elements around it, has the trace of one element; the Laplacian's matrix has Dim times that of one component.
    double laplacian = 0;
    for (const auto& q : ShapeTable<Dim>(2).points)
      for (int c = 0; c < n_corners<Dim>; ++c)
        for (int k = 0; k < Dim; ++k) laplacian += Dim * q.weight * q.dn[c][k] * q.dn[c][k];
    EXPECT_NEAR(one.factor, trace / laplacian, 1e-5 * one.factor);
  }
  // A margin that is partly used up: a fifth of what is left may be kept, whatever that is.
  auto squeezed = steps.identity;
  for (auto& x : squeezed) x[0] = 0.5 + 0.5 * (x[0] - 0.5);
  hessian.assemble(squeezed, weights);
  std::vector<double> step(steps.fold.size(), 0.0);
  const double side = elements[0].side;
  for (const auto& [share, is_beyond] : {std::pair{0.35, false}, std::pair{0.45, true}}) {
    // The determinants of the elements in front are 1/2 now, and fall by `share` at their corner in the middle.
    step[Dim * steps.middle] = share * side;
    EXPECT_EQ(!hessian.elements_beyond_margin(squeezed, step).empty(), is_beyond) << share;
  }
  // The same where a density forbids folds, and nothing where none does or it has no weight.
  hessian.assemble(steps.identity, only("volume"_term));
  EXPECT_TRUE(hessian.elements_beyond_margin(steps.identity, steps.fold).empty());
  for (const std::string_view volume : {"symmetric_dirichlet", "full"}) {
    const Steps<Dim> forbidden(volume);
    EnergyHessian<Dim> other(forbidden.problem.energy, forbidden.problem.unknowns);
    other.assemble(forbidden.identity, only("volume"_term));
    EXPECT_EQ(other.elements_beyond_margin(forbidden.identity, forbidden.fold).size(), beyond.size()) << volume;
    other.assemble(forbidden.identity, only("match"_term));
    EXPECT_TRUE(other.elements_beyond_margin(forbidden.identity, forbidden.fold).empty()) << volume;
  }
}
TEST(NewtonModel, KnowsWhereAStepUsesUpTheMargin) {
  check_margins<2>();
  check_margins<3>();
}

// Damping resists a step as far as it differs within a cell, in proportion to the factor, and is kept no longer than
// asked.
template <int Dim>
void check_damping() {
  const Steps<Dim> steps("simplified");
  TermValues weights = only("volume"_term);
  weights["barrier"_term] = 1;
  EnergyHessian<Dim> hessian(steps.problem.energy, steps.problem.unknowns);
  hessian.assemble(steps.identity, weights);
  const double fold_before = steps.energy_of(hessian, steps.fold), shift_before = steps.energy_of(hessian, steps.shift);
  const auto beyond = hessian.elements_beyond_margin(steps.identity, steps.fold);
  ASSERT_FALSE(beyond.empty());
  std::vector<double> z_before(steps.fold.size()), z(steps.fold.size());
  hessian.precondition(steps.fold, z_before);
  hessian.add_damping(beyond);
  const double once = steps.energy_of(hessian, steps.fold), added = once - fold_before;
  EXPECT_GT(once, 1.4 * fold_before);
  EXPECT_NEAR(steps.energy_of(hessian, steps.shift), shift_before, 1e-5);
  // What is preconditioned is the sum.
  hessian.precondition(steps.fold, z);
  const std::size_t i = Dim * steps.middle;
  EXPECT_NEAR(z[i] / z_before[i], fold_before / once, 1e-4);
  auto more = beyond;
  for (auto& one : more) one.factor *= 3;
  hessian.add_damping(more);
  EXPECT_NEAR(steps.energy_of(hessian, steps.fold), fold_before + 4 * added, 1e-5 * (fold_before + 4 * added));
  // The same from the start.
  std::vector<float> damping(steps.problem.unknowns.elements().size(), 0.0F);
  for (const auto& one : beyond) damping[one.element] = static_cast<float>(one.factor);
  hessian.assemble(steps.identity, weights, damping);
  EXPECT_NEAR(steps.energy_of(hessian, steps.fold), once, 1e-5 * once);
  EXPECT_NEAR(steps.energy_of(hessian, steps.shift), shift_before, 1e-5);
  // The factors are those of the energy alone, whatever the damping.
  const auto again = hessian.elements_beyond_margin(steps.identity, steps.fold);
  ASSERT_EQ(again.size(), beyond.size());
  for (std::size_t e = 0; e < again.size(); ++e) EXPECT_EQ(again[e].factor, beyond[e].factor);
  hessian.assemble(steps.identity, weights);
  EXPECT_NEAR(steps.energy_of(hessian, steps.fold), fold_before, 1e-6 * fold_before);
}
TEST(NewtonModel, DampingResistsWhatDiffersWithinACell) {
  check_damping<2>();
  check_damping<3>();
}

// A contracted step leaves the margin alone, and what moves together goes on to move together.
template <int Dim>
void check_contraction() {
  const Steps<Dim> steps("simplified");
  TermValues weights = only("volume"_term);
  weights["barrier"_term] = 1;
  EnergyHessian<Dim> hessian(steps.problem.energy, steps.problem.unknowns);
  hessian.assemble(steps.identity, weights);
  std::vector<double> d = steps.fold;
  for (std::size_t i = 0; i < d.size(); ++i) d[i] += 3 * steps.shift[i];
  const auto beyond = hessian.elements_beyond_margin(steps.identity, d);
  ASSERT_EQ(beyond.size(), static_cast<std::size_t>(n_corners<Dim> / 2));
  std::vector<double> once = d;
  hessian.contract_step(std::span(beyond).first(1), 0.5, once);
  // The element's mean stays, and from it half of the distance.
  const std::size_t x = Dim * steps.middle;
  const double mean = 3 + 0.2 / n_corners<Dim>;
  EXPECT_NEAR(once[x], mean + 0.5 * (3.2 - mean), 1e-12);
  double sum = 0;
  std::size_t n_changed = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    sum += once[i] - d[i];
    n_changed += once[i] != d[i];
  }
  EXPECT_NEAR(sum, 0, 1e-12);
  EXPECT_EQ(n_changed, static_cast<std::size_t>(n_corners<Dim>)) << "the first component of the element's nodes";
  int n = 0;
  for (auto left = beyond; !left.empty() && n < 20; ++n) {
    hessian.contract_step(left, 0.5, d);
    left = hessian.elements_beyond_margin(steps.identity, d);
  }
  EXPECT_LT(n, 4);
  for (std::size_t i = 0; i < d.size(); i += Dim) EXPECT_NEAR(d[i], 3, 0.2);
  // Where the element meets the boundary's fixed nodes there is no common motion but rest.
  const Unknowns<Dim> fixed(steps.grid, BoundaryCondition::dirichlet);
  const EnergyHessian<Dim> of_fixed(steps.problem.energy, fixed);
  std::vector<double> all(fixed.size(), 1.0);
  of_fixed.contract_step(std::vector<ElementDamping>{{0, 1.0}}, 0.5, all);
  EXPECT_EQ(std::ranges::count(all, 0.5), Dim) << "the one unknown node of the corner's element";
  EXPECT_EQ(std::ranges::count(all, 1.0), static_cast<std::ptrdiff_t>(all.size()) - Dim);
}
TEST(NewtonModel, ContractionKeepsCommonMotion) {
  check_contraction<2>();
  check_contraction<3>();
}

}  // namespace
}  // namespace shellmatch
