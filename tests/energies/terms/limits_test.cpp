// Where the energy ends: positions outside the domain, folds, numbers that are none.

#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "energies/terms/term_names.h"

#include <gtest/gtest.h>

#include <limits>

namespace shellmatch {
namespace {

using namespace test;

template <int Dim>
struct Shapes {
  Octree<Dim> grid = hanging_grid<Dim>(0.28);
  CoefficientFields<Dim> reference = exact_fields<Dim>(grid, sphere<Dim>(0.28));
  CoefficientFields<Dim> target = exact_fields<Dim>(grid, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24)));

  std::vector<Vec<Dim>> shifted(double x) const {
    return at_nodes<Dim>(grid, [=](const Vec<Dim>& p) { return Vec<Dim>(p + x * Vec<Dim>::Unit(0)); });
  }
};

template <class T>
struct Limits : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Limits, Dimensions);

TYPED_TEST(Limits, PositionsOutsideAreProjected) {
  constexpr int Dim = TypeParam::value;
  const Shapes<Dim> s;
  const Problem<Dim> p(s.grid, s.reference, s.target);
  // All of the domain lies beyond the face x = 1: the target is read on that face, however far away.
  const auto phi = s.shifted(1.5);
  EXPECT_EQ(p.value(phi, "match"_term), p.value(s.shifted(7), "match"_term));
  const auto gradient = p.gradient(phi, only("match"_term));
  double along = 0, across = 0;
  for (std::size_t i = 0; i < gradient.size(); ++i) (i % Dim == 0 ? along : across) += std::abs(gradient[i]);
  EXPECT_EQ(along, 0);
  EXPECT_GT(across, 1e-3);
  // Some positions cross the face: nothing jumps. Gauss points of this grid leave it at multiples of no such shift.
  for (const double shift : {0.2, 0.3, 0.35, 0.5})
    EXPECT_NEAR(p.value(s.shifted(shift - 1e-9), "match"_term), p.value(s.shifted(shift + 1e-9), "match"_term), 1e-7);
}

TYPED_TEST(Limits, WhatIsNotFiniteCannotBeEvaluated) {
  constexpr int Dim = TypeParam::value;
  const Shapes<Dim> s;
  const Problem<Dim> p(s.grid, s.reference, s.target);
  TermValues weights, values;
  for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = 1;
  std::vector<double> gradient(p.unknowns.size());
  EXPECT_TRUE(p.energy.evaluate(s.shifted(0), weights, values, gradient));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    for (const Index node : {Index{0}, s.grid.n_nodes() / 2, s.grid.n_nodes() - 1}) {
      auto phi = s.shifted(0);
      phi[node][Dim - 1] = bad;
      EXPECT_FALSE(p.energy.evaluate(phi, weights, values, {}));
      EXPECT_FALSE(p.energy.evaluate(phi, weights, values, gradient));
      // Nor where it is out of reach of every term that has a weight.
      EXPECT_FALSE(p.energy.evaluate(phi, only("match"_term), values, {}));
    }
  // Finite positions whose energy is not.
  auto phi = s.shifted(0);
  for (auto& y : phi) y *= 1e200;
  EXPECT_FALSE(p.energy.evaluate(phi, weights, values, {}));
}

// A mirror image folds everywhere, a node pushed through its neighbours folds somewhere.
template <int Dim>
std::vector<std::vector<Vec<Dim>>> folded_maps(const Shapes<Dim>& s) {
  auto mirrored = s.shifted(0), pushed = s.shifted(0);
  for (auto& y : mirrored) y[0] = 1 - y[0];
  for (const Index node : s.grid.free_nodes())
    if ((s.grid.node_position(node) - centre<Dim>()).norm() < 1e-9) pushed[node][0] += 0.6;
  return {mirrored, pushed};
}

TYPED_TEST(Limits, FoldsCannotBeEvaluatedUnderDensitiesThatForbidThem) {
  constexpr int Dim = TypeParam::value;
  const Shapes<Dim> s;
  for (const auto& phi : folded_maps<Dim>(s))
    for (const std::string_view volume : {"simplified", "full", "symmetric_dirichlet"}) {
      ProblemOptions o;
      o.energy.terms.model("volume"_term) = volume;
      const Problem<Dim> p(s.grid, s.reference, s.target, o);
      const bool allowed = volume == "simplified";
      EXPECT_EQ(p.values(phi, only("volume"_term)).has_value(), allowed) << volume;
      TermValues values;
      std::vector<double> gradient(p.unknowns.size());
      EXPECT_EQ(p.energy.evaluate(phi, only("volume"_term), values, gradient), allowed) << volume;
      // Band terms alone ask for no orientation, and a weight of 0 switches the density off.
      EXPECT_TRUE(p.values(phi, only("membrane"_term)).has_value());
      EXPECT_FALSE(p.values(phi, only("barrier"_term)).has_value());
      EXPECT_FALSE(p.energy.evaluate(phi, only("barrier"_term), values, gradient));
    }
}

// Affine maps have the same density everywhere, whatever the Gauss rule.
TYPED_TEST(Limits, VolumeIsThatOfTheDomainForEveryQuadrature) {
  constexpr int Dim = TypeParam::value;
  const Shapes<Dim> s;
  Mat<Dim> a = Mat<Dim>::Identity();
  a(0, 0) = 0.8;
  a(0, 1) = 0.1;
  const auto phi = at_nodes<Dim>(s.grid, [&](const Vec<Dim>& x) { return Vec<Dim>(a * x); });
  double first = 0;
  for (int n = 1; n <= max_gauss_points; ++n) {
    ProblemOptions o;
    o.points_per_direction = n;
    const Problem<Dim> p(s.grid, s.reference, s.target, o);
    const double value = p.value(phi, "volume"_term);
    if (n == 1) first = value;
    EXPECT_GT(value, 1e-3);
    EXPECT_NEAR(value, first, 1e-13) << n;
  }
}

// Values with and without gradient are the same numbers, and terms add up with their weights.
TYPED_TEST(Limits, TermsAddUp) {
  constexpr int Dim = TypeParam::value;
  const Shapes<Dim> s;
  ProblemOptions o;
  o.energy.terms.own("fold_threshold") = 0.9;
  o.energy.delta = 0.5;
  o.energy.terms.factor("bending"_term) = 3;
  o.energy.terms.factor("barrier"_term) = 0.7;
  const Problem<Dim> p(s.grid, s.reference, s.target, o);
  const auto phi = deformed<Dim>(s.grid, 0.04, 3);
  const TermValues weights = term_weights(o.energy, 0.01, 0.2);
  const double expected[] = {100, 0.5, 3 * 0.125, 0.2, 7};
  TermValues with_gradient;
  std::vector<double> gradient(p.unknowns.size());
  ASSERT_TRUE(p.energy.evaluate(phi, weights, with_gradient, gradient));
  const auto without = p.values(phi, weights);
  ASSERT_TRUE(without.has_value());
  std::vector<double> sum(gradient.size(), 0.0);
  ASSERT_EQ(weights.size(), std::size(expected));
  for (std::size_t t = 0; t < weights.size(); ++t) {
    SCOPED_TRACE(term_names()[t]);
    const Term term{t};
    const double alone = p.value(phi, term);
    EXPECT_GT(alone, 0);
    EXPECT_NEAR(weights[t], expected[t], 1e-15 * expected[t]);
    EXPECT_NEAR((*without)[term], expected[t] * alone, 1e-13 * expected[t] * alone);
    EXPECT_NEAR(with_gradient[term], (*without)[term], 1e-13 * (*without)[term]);
    const auto part = p.gradient(phi, only(term));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weights[term] * part[i];
  }
  for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_NEAR(gradient[i], sum[i], 1e-11);
}

}  // namespace
}  // namespace shellmatch
