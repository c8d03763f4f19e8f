// A term that is not in the program, with an option of its own, added to an energy from outside: value, gradient and
// Newton's model come with it.

#include "energies/compiled/compile_term.h"
#include "energies/assembly/ceres_evaluator.h"
#include "energies/hessian/energy_hessian.h"
#include "energies/terms/term_names.h"
#include "docs/examples/normal_alignment.h"
#include "tests/energies/hessian/model_by_differences.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "tests/support/taylor.h"

#include <gtest/gtest.h>

#include <numeric>

namespace shellmatch {
namespace {

using namespace test;
using example::NormalAlignment;

template <class T>
struct TermOfOnesOwn : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(TermOfOnesOwn, Dimensions);

template <int Dim>
struct WithNormalAlignment {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const Problem<Dim> problem{grid, exact_fields<Dim>(grid, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.25, 0.32))),
                             exact_fields<Dim>(grid, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24))), smooth()};
  const std::shared_ptr<EnergyTerms<Dim>> terms = std::make_shared<EnergyTerms<Dim>>(problem.options);
  const Term alignment;
  const MatchingEnergy<Dim> energy{problem.unknowns, problem.geometry, terms, problem.sigma, 2};
  const std::vector<Vec<Dim>> phi = deformed<Dim>(grid, 0.03, 11);

  /// \param own  values of the term's options; empty for its defaults
  explicit WithNormalAlignment(std::vector<double> own)
      : alignment(terms->add(compile_term<NormalAlignment<Dim>>(), std::move(own))) {}

  static ProblemOptions smooth() {
    ProblemOptions o;
    o.smooth = true;
    return o;
  }
  TermValues weights(double of_alignment) const {
    TermValues w(terms->size());
    w[alignment] = of_alignment;
    return w;
  }
  double value(const std::vector<Vec<Dim>>& at, const TermValues& w) const {
    TermValues values(terms->size());
    EXPECT_TRUE(energy.evaluate(at, w, values, {}));
    return values.sum();
  }
};

TYPED_TEST(TermOfOnesOwn, HasAPlaceANameAndDefaults) {
  constexpr int Dim = TypeParam::value;
  const WithNormalAlignment<Dim> by_default({}), one({1.0}), two({2.0});
  EXPECT_EQ(by_default.terms->size(), term_names().size() + 1);
  EXPECT_EQ(static_cast<std::size_t>(by_default.alignment), term_names().size());
  EXPECT_EQ(by_default.terms->names().back(), "normal_alignment");
  EXPECT_EQ(by_default.energy.terms().names().front(), "match");
  const TermValues w = one.weights(0.8);
  EXPECT_GT(one.value(one.phi, w), 1e-3);
  EXPECT_EQ(by_default.value(one.phi, w), one.value(one.phi, w));
  EXPECT_GT(two.value(one.phi, w), 2 * one.value(one.phi, w)) << "the option counts";
  EXPECT_NEAR(one.value(one.phi, one.weights(1.6)), 2 * one.value(one.phi, w), 1e-12);
}

TYPED_TEST(TermOfOnesOwn, ValueAndGradientAreThoseOfItsFunctor) {
  constexpr int Dim = TypeParam::value;
  const WithNormalAlignment<Dim> a({1.3});
  TermValues weights = a.weights(0.8), values(weights.size());
  weights["match"_term] = 2;  // beside a term of the list
  const auto& unknowns = a.problem.unknowns;
  std::vector<double> gradient(unknowns.size());
  ASSERT_TRUE(a.energy.evaluate(a.phi, weights, values, gradient));
  EXPECT_GT(values[a.alignment], 0);

  const CeresEvaluator<Dim> costs(a.energy);
  constexpr int n_dofs = CeresEvaluator<Dim>::n_dofs;
  const std::size_t n = unknowns.elements().size();
  std::vector<double> of_elements(n * n_dofs);
  double sum = 0;
  for (std::size_t e = 0; e < n; ++e) {
    const auto dofs = costs.dofs_of(e, a.phi);
    typename CeresEvaluator<Dim>::Dofs derivative;
    sum += costs.gradient(weights, e, dofs, derivative);
    std::copy(derivative.begin(), derivative.end(), of_elements.begin() + static_cast<std::ptrdiff_t>(e * n_dofs));
  }
  EXPECT_NEAR(values.sum(), sum, 1e-12 * sum);
  const auto expected = sum_elements<Dim>(unknowns, of_elements);
  double size = 0, error = 0;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    size = std::max(size, std::abs(expected[i]));
    error = std::max(error, std::abs(gradient[i] - expected[i]));
  }
  EXPECT_LT(error, 1e-11 * size);

  // And the derivative is that of the value.
  const auto direction = at_nodes<Dim>(a.grid, smooth_field<Dim>(3));
  std::vector<double> v(gradient.size());
  unknowns.restrict_to(direction, v);
  const double slope = std::inner_product(gradient.begin(), gradient.end(), v.begin(), 0.0);
  const auto line = [&](double t) {
    auto moved = a.phi;
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += t * direction[i];
    return a.value(moved, weights);
  };
  EXPECT_TRUE(has_derivative(line, slope));
  EXPECT_FALSE(has_derivative(line, 1.01 * slope));
}

TYPED_TEST(TermOfOnesOwn, NewtonsModelIsThatOfGaussAndNewton) {
  constexpr int Dim = TypeParam::value;
  const std::array own{1.3};
  const WithNormalAlignment<Dim> a({own[0]});
  const auto& unknowns = a.problem.unknowns;
  EnergyHessian<Dim> hessian(a.energy, unknowns);
  hessian.assemble(a.phi, a.weights(1));
  const auto direction = at_nodes<Dim>(a.grid, smooth_field<Dim>(3));
  std::vector<double> v(unknowns.size()), hv(v.size());
  unknowns.restrict_to(direction, v);
  hessian.apply(v, hv);
  const double model = std::inner_product(v.begin(), v.end(), hv.begin(), 0.0);
  const double expected = ModelByDifferences<NormalAlignment<Dim>>(a.problem, own)(a.phi, direction);
  EXPECT_GT(expected, 0);
  EXPECT_NEAR(model, expected, 1e-5 * expected);
}

}  // namespace
}  // namespace shellmatch
