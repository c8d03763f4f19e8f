// Point pairs on grids with hanging nodes: value against the interpolated map, gradient by the Taylor remainder and by
// dual numbers, Newton's model against second differences, and the same bits whatever the number of threads.

#include "base/parallel.h"
#include "energies/assembly/ceres_evaluator.h"
#include "energies/hessian/energy_hessian.h"
#include "grid/fields/interpolation.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "tests/grid/test_grids.h"
#include "tests/support/taylor.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <bit>
#include <numeric>
#include <random>

namespace shellmatch {
namespace {

using namespace test;

/// Random pairs all over the domain, every other one with a normal: on corners, faces and the boundary too.
template <int Dim>
PointPairs<Dim> random_pairs(RobustLoss loss, std::size_t n, double tolerance) {
  std::mt19937 random(11);
  PointPairs<Dim> all{.pairs = {}, .loss = loss, .scale = 0.05, .tolerance = tolerance};
  for (std::size_t i = 0; i < n; ++i) {
    PointPair<Dim> pair{random_point<Dim>(random, 0, 1), Vec<Dim>::Zero()};
    if (i % 7 == 0) pair.p = (pair.p * 8).array().round().matrix() / 8;
    if (i % 11 == 0) pair.p[0] = i % 2 == 0 ? 0 : 1;
    pair.y = pair.p + random_point<Dim>(random, -0.1, 0.1);
    pair.weight = 0.5 + 0.01 * static_cast<double>(i % 50);
    if (i % 2 == 0) pair.normal = random_point<Dim>(random, -1, 1).normalized();
    all.pairs.push_back(pair);
  }
  return all;
}

/// The energy of a small matching with a term of pairs of its own.
template <int Dim>
struct WithPairs {
  const Octree<Dim> grid;
  const CoefficientFields<Dim> fields;
  Problem<Dim> problem;
  PointPairs<Dim> pairs;
  Term term;
  TermValues weights;  ///< of the pairs alone
  std::vector<Vec<Dim>> phi;

  explicit WithPairs(RobustLoss loss, BoundaryCondition boundary = BoundaryCondition::neumann, std::size_t n = 300,
                     double tolerance = 0)
      : grid(hanging_grid<Dim>(0.28)),
        fields(exact_fields<Dim>(grid, sphere<Dim>(0.28))),
        problem(grid, fields, fields, {.energy = with(boundary)}),
        pairs(random_pairs<Dim>(loss, n, tolerance)),
        term(problem.terms->add("pairs", PairTerm<Dim>(grid, pairs), [](const TermScales&) { return 1.0; })),
        weights(problem.energy.n_terms()),
        phi(deformed<Dim>(grid, 0.03, 5, boundary == BoundaryCondition::dirichlet)) {
    weights[term] = 3;
  }
  static EnergyOptions with(BoundaryCondition boundary) {
    EnergyOptions o;
    o.boundary = boundary;
    return o;
  }
  double value(const std::vector<Vec<Dim>>& at) const { return (*problem.values(at, weights))[term]; }
  /// A direction by the unknowns: smooth, and independent at each node.
  std::vector<double> direction() const {
    std::vector<double> v(problem.unknowns.size());
    problem.unknowns.restrict_to(at_nodes<Dim>(grid, smooth_field<Dim>(3)), v);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> noise(-1, 1);
    for (double& x : v) x += noise(random);
    return v;
  }
  std::vector<Vec<Dim>> moved(const std::vector<double>& v, double t) const {
    std::vector<double> x(v.size());
    problem.unknowns.restrict_to(phi, x);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += t * v[i];
    auto at = phi;
    problem.unknowns.expand(x, at);
    return at;
  }
};

template <class T>
struct Pairs : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Pairs, Dimensions);

constexpr std::array all_losses = {RobustLoss::trivial, RobustLoss::huber, RobustLoss::cauchy};

TYPED_TEST(Pairs, ValueIsThatOfTheInterpolatedMap) {
  constexpr int Dim = TypeParam::value;
  for (const RobustLoss loss : all_losses) {
    const WithPairs<Dim> a(loss);
    double expected = 0;
    for (const auto& pair : a.pairs.pairs) {
      const Vec<Dim> gap = evaluate(a.grid, a.phi, pair.p) - pair.y;
      const double along = pair.normal.dot(gap);
      expected += 3 * pair.weight * robust_loss(loss, 0.05, pair.normal.isZero() ? gap.squaredNorm() : along * along);
    }
    EXPECT_NEAR(a.value(a.phi), expected, 1e-12 * expected) << enum_name(loss);
    // And alone, as reports add it.
    TermValues values(a.problem.energy.n_terms());
    values[a.term] = 17;
    a.problem.energy.set_point_values(a.phi, a.weights, values);
    EXPECT_NEAR(values[a.term], expected, 1e-12 * expected);
  }
}

TYPED_TEST(Pairs, GradientIsTheDerivative) {
  constexpr int Dim = TypeParam::value;
  for (const auto boundary : {BoundaryCondition::neumann, BoundaryCondition::dirichlet})
    for (const RobustLoss loss : all_losses) {
      SCOPED_TRACE(fmt::format("{}, {}", enum_name(boundary), enum_name(loss)));
      const WithPairs<Dim> a(loss, boundary);
      ASSERT_FALSE(a.grid.hanging_nodes().empty());
      const auto v = a.direction(), g = a.problem.gradient(a.phi, a.weights);
      const double slope = std::inner_product(g.begin(), g.end(), v.begin(), 0.0);
      const auto line = [&](double t) { return a.value(a.moved(v, t)); };
      EXPECT_TRUE(has_derivative(line, slope));
      EXPECT_FALSE(has_derivative(line, 1.01 * slope));
    }
}

TYPED_TEST(Pairs, ElementsAgreeWithDualNumbers) {
  constexpr int Dim = TypeParam::value;
  for (const RobustLoss loss : all_losses) {
    const WithPairs<Dim> a(loss);
    const CeresEvaluator<Dim> costs(a.problem.energy);
    TermValues values;
    std::vector<double> gradient(a.problem.unknowns.size()), of_elements;
    ASSERT_TRUE(a.problem.energy.evaluate(a.phi, a.weights, values, gradient, &of_elements));
    double sum = 0;
    std::size_t n_acting = 0;
    for (std::size_t e = 0; e < a.problem.unknowns.elements().size(); ++e) {
      typename CeresEvaluator<Dim>::Dofs by_jets;
      sum += costs.gradient(a.weights, e, costs.dofs_of(e, a.phi), by_jets);
      for (std::size_t i = 0; i < by_jets.size(); ++i)
        EXPECT_NEAR(by_jets[i], of_elements[e * by_jets.size() + i], 1e-12) << e;
      n_acting += by_jets[0] != 0;
    }
    EXPECT_GT(n_acting, 100u);
    EXPECT_NEAR(sum, values[a.term], 1e-12 * sum);
  }
}

// The model is the second derivative of the same energy with the losses' weights held: of the energy itself without
// one.
TYPED_TEST(Pairs, ModelIsThatOfGaussAndNewton) {
  constexpr int Dim = TypeParam::value;
  for (const RobustLoss loss : all_losses) {
    SCOPED_TRACE(enum_name(loss));
    const WithPairs<Dim> a(loss);
    EnergyHessian<Dim> hessian(a.problem.energy, a.problem.unknowns);
    hessian.assemble(a.phi, a.weights);
    const auto v = a.direction();
    std::vector<double> hv(v.size());
    hessian.apply(v, hv);
    const double model = std::inner_product(v.begin(), v.end(), hv.begin(), 0.0);
    const auto held = [&](double t) {
      const auto at = a.moved(v, t);
      double sum = 0;
      for (const auto& pair : a.pairs.pairs) {
        const auto square = [&](const std::vector<Vec<Dim>>& x) {
          const Vec<Dim> gap = evaluate(a.grid, x, pair.p) - pair.y;
          return pair.normal.isZero() ? gap.squaredNorm() : std::pow(pair.normal.dot(gap), 2);
        };
        sum += 3 * pair.weight * robust_weight(loss, 0.05, square(a.phi)) * square(at);
      }
      return sum;
    };
    const double expected = held(1) - 2 * held(0) + held(-1);
    EXPECT_GT(expected, 0);
    EXPECT_NEAR(model, expected, 1e-5 * expected);
    if (loss == RobustLoss::trivial) {
      const double exact = a.value(a.moved(v, 1)) - 2 * a.value(a.phi) + a.value(a.moved(v, -1));
      EXPECT_NEAR(model, exact, 1e-5 * exact);
    }
  }
}

// Distances up to the tolerance cost nothing; beyond it the rest counts. Single pairs, so that none is at its kink.
TYPED_TEST(Pairs, WithinTheToleranceTheyRest) {
  constexpr int Dim = TypeParam::value;
  const WithPairs<Dim> far(RobustLoss::trivial, BoundaryCondition::neumann, 1, 0.001);
  const WithPairs<Dim> near(RobustLoss::trivial, BoundaryCondition::neumann, 1, 0.5);
  for (const auto* a : {&far, &near}) {
    const auto& pair = a->pairs.pairs[0];
    const double gap = std::abs(pair.normal.dot(evaluate(a->grid, a->phi, pair.p) - pair.y));
    const double beyond = std::max(0.0, gap - a->pairs.tolerance);
    ASSERT_EQ(beyond > 0, a == &far);
    EXPECT_NEAR(a->value(a->phi), 3 * pair.weight * beyond * beyond, 1e-14);
    const auto v = a->direction(), g = a->problem.gradient(a->phi, a->weights);
    const double slope = std::inner_product(g.begin(), g.end(), v.begin(), 0.0);
    EnergyHessian<Dim> hessian(a->problem.energy, a->problem.unknowns);
    hessian.assemble(a->phi, a->weights);
    std::vector<double> hv(v.size());
    hessian.apply(v, hv);
    const double model = std::inner_product(v.begin(), v.end(), hv.begin(), 0.0);
    const CeresEvaluator<Dim> costs(a->problem.energy);
    double by_functor = 0;
    for (std::size_t e = 0; e < a->problem.unknowns.elements().size(); ++e)
      by_functor += costs.value(a->weights, e, costs.dofs_of(e, a->phi));
    EXPECT_NEAR(by_functor, a->value(a->phi), 1e-14);
    if (a == &near) {
      EXPECT_EQ(slope, 0);
      EXPECT_EQ(model, 0);
      continue;
    }
    const auto line = [&](double t) { return a->value(a->moved(v, t)); };
    EXPECT_TRUE(has_derivative(line, slope));
    const double t = 1e-3, exact = (line(t) - 2 * line(0) + line(-t)) / (t * t);
    EXPECT_NEAR(model, exact, 1e-4 * exact);
  }
}

// A pair at rest that a step carries out of its tolerance: the model then has the value's slope and second derivative
// along the step, as if the pair were beyond already: with v the step, of (d/dt)^2 w rho' |B (phi(p) + t v - y) - b|^2.
TYPED_TEST(Pairs, AStepBeyondTheToleranceBringsThemIntoTheModel) {
  constexpr int Dim = TypeParam::value;
  for (const RobustLoss loss : all_losses)
    for (const auto boundary : {BoundaryCondition::neumann, BoundaryCondition::dirichlet}) {
      SCOPED_TRACE(fmt::format("{}, {}", enum_name(boundary), enum_name(loss)));
      const double tolerance = 0.2;  // no pair is farther apart
      const WithPairs<Dim> a(loss, boundary, 300, tolerance);
      ASSERT_EQ(a.value(a.phi), 0);
      EnergyHessian<Dim> hessian(a.problem.energy, a.problem.unknowns);
      hessian.assemble(a.phi, a.weights);
      auto v = a.direction();
      for (double& x : v) x *= 0.3;
      std::vector<double> g(v.size(), 0.0), hv(v.size());
      const std::size_t n = hessian.extend(a.phi, v, a.weights, g);
      hessian.apply(v, hv);
      const double slope = std::inner_product(v.begin(), v.end(), g.begin(), 0.0);
      const double curvature = std::inner_product(v.begin(), v.end(), hv.begin(), 0.0);

      const auto end = a.moved(v, 1);
      std::size_t n_beyond = 0;
      double expected_slope = 0, expected_curvature = 0;
      for (const auto& pair : a.pairs.pairs) {
        const auto counted = [&](const Vec<Dim>& x) {
          return pair.normal.isZero() ? x : Vec<Dim>(pair.normal.dot(x) * pair.normal);
        };
        const Vec<Dim> before = counted(evaluate(a.grid, a.phi, pair.p) - pair.y),
                       after = counted(evaluate(a.grid, end, pair.p) - pair.y);
        const double beyond = after.norm() - tolerance;
        if (beyond <= 0) continue;
        ++n_beyond;
        const double factor = 2 * 3 * pair.weight * robust_weight(loss, 0.05, beyond * beyond);
        expected_slope += factor * (before - tolerance * after.normalized()).dot(after - before);
        expected_curvature += factor * (after - before).squaredNorm();
      }
      EXPECT_GT(n_beyond, 20u);
      EXPECT_LT(n_beyond, a.pairs.pairs.size());
      EXPECT_EQ(n, n_beyond);
      EXPECT_LT(slope, 0);
      EXPECT_NEAR(slope, expected_slope, 1e-9 * std::abs(expected_slope));
      EXPECT_NEAR(curvature, expected_curvature, 1e-5 * expected_curvature);

      // Once for each model, and no longer than it.
      EXPECT_EQ(hessian.extend(a.phi, v, a.weights, g), 0u);
      hessian.assemble(a.phi, a.weights);
      hessian.apply(v, hv);
      EXPECT_EQ(std::inner_product(v.begin(), v.end(), hv.begin(), 0.0), 0);
    }
}

TYPED_TEST(Pairs, OtherTermsDoNotSeeThem) {
  constexpr int Dim = TypeParam::value;
  const WithPairs<Dim> a(RobustLoss::trivial);
  const Problem<Dim> without(a.grid, a.fields, a.fields);
  TermValues all(a.problem.energy.n_terms()), listed;
  for (std::size_t t = 0; t < listed.size(); ++t) all[t] = listed[t] = 1;
  EXPECT_EQ(a.problem.gradient(a.phi, all), without.gradient(a.phi, listed));
  EXPECT_EQ(a.problem.values(a.phi, all)->sum(), without.values(a.phi, listed)->sum());
  const auto names = a.problem.energy.term_names();
  ASSERT_EQ(names.size(), listed.size() + 1);
  EXPECT_EQ(names.back(), "pairs");
}

TYPED_TEST(Pairs, SameBitsForAnyNumberOfThreads) {
  constexpr int Dim = TypeParam::value;
  const auto bits = [](int threads) {
    set_n_threads(threads);
    const WithPairs<Dim> a(RobustLoss::cauchy, BoundaryCondition::neumann, 5000);
    EnergyHessian<Dim> hessian(a.problem.energy, a.problem.unknowns);
    hessian.assemble(a.phi, a.weights);
    const auto v = a.direction();
    std::vector<double> all = a.problem.gradient(a.phi, a.weights), hv(v.size());
    hessian.apply(v, hv);
    all.insert(all.end(), hv.begin(), hv.end());
    all.push_back(a.value(a.phi));
    const WithPairs<Dim> at_rest(RobustLoss::cauchy, BoundaryCondition::neumann, 5000, 0.2);
    EnergyHessian<Dim> extended(at_rest.problem.energy, at_rest.problem.unknowns);
    extended.assemble(at_rest.phi, at_rest.weights);
    std::vector<double> g(v.size(), 0.0);
    EXPECT_GT(extended.extend(at_rest.phi, v, at_rest.weights, g), 1000u);
    all.insert(all.end(), g.begin(), g.end());
    set_n_threads(0);
    std::vector<std::uint64_t> result;
    for (const double x : all) result.push_back(std::bit_cast<std::uint64_t>(x));
    return result;
  };
  const auto one = bits(1);
  for (const int threads : {2, 3}) EXPECT_EQ(bits(threads), one) << threads;
}

}  // namespace
}  // namespace shellmatch
