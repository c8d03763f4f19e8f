// The energy as problems of Ceres: first-order functions, and residuals of squares and of pairs with Ceres' losses.

#include "energies/assembly/ceres_problem.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <ceres/problem.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace shellmatch {
namespace {

using namespace test;

template <int Dim>
struct Squares {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  Problem<Dim> problem;
  MatchingEnergy<Dim>& energy;
  const std::vector<Vec<Dim>> phi;
  TermValues weights;
  std::vector<double> x;

  explicit Squares(BoundaryCondition boundary)
      : problem(grid, exact_fields<Dim>(grid, sphere<Dim>(0.28)),
                exact_fields<Dim>(grid, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24))), options(boundary)),
        energy(problem.energy),
        phi(deformed<Dim>(grid, 0.03, 11, boundary == BoundaryCondition::dirichlet)),
        x(problem.unknowns.size()) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.2, 0.8);
    const std::size_t n_without = energy.n_terms();
    for (const RobustLoss loss : {RobustLoss::trivial, RobustLoss::huber, RobustLoss::cauchy})
      for (const double tolerance : {0.0, 0.02}) {
        PointPairs<Dim> pairs{.pairs = {}, .loss = loss, .scale = 0.05, .tolerance = tolerance};
        for (int i = 0; i < 20; ++i) {
          PointPair<Dim> pair{.p = {}, .y = {}, .weight = uniform(random)};
          for (int k = 0; k < Dim; ++k) pair.p[k] = uniform(random);
          for (int k = 0; k < Dim; ++k) pair.y[k] = pair.p[k] + 0.1 * (uniform(random) - 0.5);
          if (i % 3 == 0) pair.normal = Vec<Dim>::LinSpaced(1, 2).normalized();
          pairs.pairs.push_back(pair);
        }
        problem.terms->add("pairs", PairTerm<Dim>(grid, pairs), [](const TermScales&) { return 1.0; });
      }
    weights = TermValues(energy.n_terms());
    for (std::size_t t = n_without; t < weights.size(); ++t) weights[t] = 0.3 + 0.1 * static_cast<double>(t);
    weights["match"_term] = 2;
    weights["bending"_term] = 0.5;
    problem.unknowns.restrict_to(phi, x);
  }
  static ProblemOptions options(BoundaryCondition boundary) {
    ProblemOptions o;
    o.energy.boundary = boundary;
    o.energy.terms.model("bending"_term) = "quadratic";
    return o;
  }
};

template <class T>
struct CeresProblem : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(CeresProblem, Dimensions);

TYPED_TEST(CeresProblem, OfSquaresHasTheirCostAndGradient) {
  constexpr int Dim = TypeParam::value;
  for (const auto boundary : {BoundaryCondition::neumann, BoundaryCondition::dirichlet}) {
    Squares<Dim> a(boundary);
    ceres::Problem squares;
    EXPECT_TRUE(add_residuals<Dim>(a.energy, a.problem.unknowns, a.weights, a.phi, a.x, squares).empty());
    double cost = 0;
    ceres::Problem::EvaluateOptions order;  // the blocks in the order of the unknowns
    for (std::size_t i = 0; i < a.x.size(); i += Dim)
      if (squares.HasParameterBlock(a.x.data() + i)) order.parameter_blocks.push_back(a.x.data() + i);
    std::vector<double> by_ceres;
    ASSERT_TRUE(squares.Evaluate(order, &cost, nullptr, &by_ceres, nullptr));

    const EnergyFunction<Dim> function(a.energy, a.problem.unknowns, a.weights, a.phi);
    double value = 0;
    std::vector<double> gradient(a.x.size());
    ASSERT_TRUE(function.Evaluate(a.x.data(), &value, gradient.data()));
    EXPECT_GT(value, 0);
    EXPECT_NEAR(cost, value, 1e-12 * value);
    const double size = std::abs(*std::ranges::max_element(gradient, {}, [](double g) { return std::abs(g); }));
    for (std::size_t b = 0; b < order.parameter_blocks.size(); ++b)
      for (int k = 0; k < Dim; ++k)
        EXPECT_NEAR(by_ceres[b * Dim + static_cast<std::size_t>(k)],
                    gradient[static_cast<std::size_t>(order.parameter_blocks[b] + k - a.x.data())], 1e-12 * size);
  }
}

TYPED_TEST(CeresProblem, LeavesOutWhatIsNoSquareAndSaysSo) {
  constexpr int Dim = TypeParam::value;
  Squares<Dim> a(BoundaryCondition::neumann);
  a.weights = TermValues(a.energy.n_terms());
  a.weights["membrane"_term] = a.weights["barrier"_term] = 1;
  ceres::Problem squares;
  EXPECT_EQ(add_residuals<Dim>(a.energy, a.problem.unknowns, a.weights, a.phi, a.x, squares),
            (std::vector<std::string>{"membrane", "barrier"}));
  EXPECT_EQ(squares.NumResiduals(), 0);
}

}  // namespace
}  // namespace shellmatch
