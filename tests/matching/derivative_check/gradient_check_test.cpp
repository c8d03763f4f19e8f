// The check finds what is wrong, says where, and finds nothing where nothing is.

#include "matching/derivative_check/gradient_check.h"

#include "base/error.h"
#include "matching/level/shape_fields.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "energies/terms/term_names.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace shellmatch {
namespace {

using namespace test;

ExperimentOptions experiment(BoundaryCondition boundary = BoundaryCondition::neumann) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.energy.boundary = boundary;
  o.energy.terms.own("fold_threshold") = 0.9;
  return o;
}

/// Two spheres on a grid with hanging nodes, and a deformation at which every term acts.
template <int Dim>
struct Setting {
  explicit Setting(const ExperimentOptions& o = experiment(), double amplitude = 0.04)
      : options(o), phi(deformed<Dim>(grid, amplitude, 7, o.energy.boundary == BoundaryCondition::dirichlet)) {
    for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = 1;
  }
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const CoefficientFields<Dim> reference = exact_fields<Dim>(grid, sphere<Dim>(0.28));
  const CoefficientFields<Dim> target = exact_fields<Dim>(grid, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24)));
  ExperimentOptions options;
  LevelEnergy<Dim> level{grid, multilinear_geometry(grid, reference, target, options), options};
  std::vector<Vec<Dim>> phi;
  TermValues weights;

  GradientReport check(const CheckedEnergy<Dim>& energy) {
    return check_gradient<Dim>(level, energy, phi, weights,
                               {.n_directions = 1, .seed = 1, .most_differenced = 60, .n_ceres_elements = 2});
  }
};

std::string told(const GradientReport& report) { return gradient_report_text(report); }

enum class Fault { every_element, one_element, one_unknown };

/// An energy of which one term's gradient is one per cent too long, everywhere or at one place.
template <int Dim>
class Planted final : public CheckedEnergy<Dim> {
 public:
  Planted(const LevelEnergy<Dim>& level, Term term, Fault fault)
      : CheckedEnergy<Dim>(level), term_(term), fault_(fault) {}

  bool evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                std::span<double> gradient, std::vector<double>& element_gradients) const override {
    if (!CheckedEnergy<Dim>::evaluate(phi, weights, values, gradient, element_gradients)) return false;
    if (gradient.empty() || !(weights[term_] > 0)) return true;
    std::vector<double> share(gradient.size()), elements;
    TermValues ignored;
    if (!CheckedEnergy<Dim>::evaluate(phi, only(term_), ignored, share, elements)) return false;
    if (fault_ == Fault::one_unknown) {
      const auto largest = std::ranges::max_element(share, {}, [](double g) { return std::abs(g); });
      gradient[static_cast<std::size_t>(largest - share.begin())] += 0.01 * *largest;
      return true;
    }
    constexpr std::size_t n = n_corners<Dim> * Dim;
    // Away from the largest: the middle one of those on which the term acts.
    std::vector<std::size_t> acting;
    for (std::size_t e = 0; e * n < elements.size(); ++e)
      if (std::abs(elements[e * n]) > 0) acting.push_back(e);
    wrong_ = acting[acting.size() / 2];
    for (std::size_t i = 0; i < elements.size(); ++i) {
      elements[i] *= fault_ == Fault::every_element || i / n == wrong_ ? 0.01 : 0.0;
      element_gradients[i] += elements[i];
    }
    share = sum_elements(this->level_.unknowns, std::span<const double>(elements));
    for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] += share[i];
    return true;
  }
  Index wrong_element() const { return static_cast<Index>(wrong_); }

 private:
  Term term_;
  Fault fault_;
  mutable std::size_t wrong_ = 0;
};

template <class T>
struct GradientCheck : ::testing::Test {
  static constexpr int Dim = T::value;
};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(GradientCheck, Dimensions);

TYPED_TEST(GradientCheck, PassesWhatIsRight) {
  constexpr int D = TypeParam::value;
  for (const auto boundary : {BoundaryCondition::neumann, BoundaryCondition::dirichlet}) {
    Setting<D> s(experiment(boundary));
    const GradientReport report = s.check(CheckedEnergy<D>(s.level));
    EXPECT_TRUE(report.passed()) << told(report);
    ASSERT_EQ(report.terms.size(), term_names().size() + 1);
    for (const TermCheck& t : report.terms) {
      EXPECT_EQ(t.state, TermCheck::State::passed) << told(report);
      ASSERT_EQ(t.directions.size(), 1u);
      EXPECT_TRUE(t.directions[0].resolved) << told(report);
      ASSERT_EQ(t.directions[0].orders.size(), 3u);
      for (const double order : t.directions[0].orders) EXPECT_NEAR(order, 2, 0.1) << told(report);
      EXPECT_GT(t.ceres.n_elements, 0);
      EXPECT_GT(t.n_differenced, 0u);
      ASSERT_TRUE(t.hessian.has_value()) << t.name << told(report);
    }
  }
}

TYPED_TEST(GradientCheck, FindsAWrongTerm) {
  constexpr int D = TypeParam::value;
  Setting<D> s;
  const std::size_t n_terms = term_names().size();
  for (std::size_t t = 0; t < n_terms; ++t)
    for (const Fault fault : {Fault::every_element, Fault::one_element, Fault::one_unknown}) {
      SCOPED_TRACE(std::string(term_names()[t]) + ", fault " + std::to_string(static_cast<int>(fault)));
      // Beside the next term, which is right.
      s.weights = only(Term{t});
      s.weights[(t + 1) % n_terms] = 1;
      const Planted<D> planted(s.level, Term{t}, fault);
      const GradientReport report = s.check(planted);
      EXPECT_FALSE(report.passed());
      // It is this term, and no other: the sum may drown the error of a single place in larger terms.
      for (std::size_t i = 0; i < n_terms; ++i)
        EXPECT_EQ(report.terms[i].state == TermCheck::State::failed, i == t) << told(report);
      const TermCheck& wrong = report.terms[t];
      if (fault == Fault::every_element) {
        EXPECT_EQ(wrong.ceres.n_failed, wrong.ceres.n_elements);
        EXPECT_GT(wrong.difference_error, 1);
        EXPECT_GT(std::abs(wrong.directions[0].orders[2] - 2), 0.1);
      }
      if (fault == Fault::one_element) {
        EXPECT_EQ(wrong.worst->element, planted.wrong_element());
        EXPECT_NEAR(wrong.worst->analytic, 1.01 * wrong.worst->by_differences, 1e-4 * std::abs(wrong.worst->analytic));
        const Vec<D> centre = s.grid.cell_centre(s.grid.leaves()[planted.wrong_element()]);
        for (int k = 0; k < D; ++k) EXPECT_EQ(wrong.worst->centre[k], centre[k]);
      }
    }
}

// The terms that are there to compare with have functors and a Newton model of their own.
TYPED_TEST(GradientCheck, PassesTheEnergiesToCompareWith) {
  constexpr int D = TypeParam::value;
  for (const auto& [membrane, bending] : {std::pair{"no_p2", "no_p2"}, std::pair{"cauchy_green", "quadratic"}}) {
    ExperimentOptions o = experiment();
    o.energy.terms.model("membrane"_term) = membrane;
    o.energy.terms.model("bending"_term) = bending;
    Setting<D> s(o);
    s.weights["match"_term] = s.weights["volume"_term] = s.weights["barrier"_term] = 0;
    const GradientReport report = s.check(CheckedEnergy<D>(s.level));
    for (const Term t : {"membrane"_term, "bending"_term}) {
      const TermCheck& check = report.terms[static_cast<std::size_t>(t)];
      EXPECT_EQ(check.state, TermCheck::State::passed) << told(report);
      EXPECT_TRUE(check.hessian.has_value()) << told(report);
    }
  }
}

// Near the identity no cell comes near to folding, and there the volume term is at its minimum.
TYPED_TEST(GradientCheck, SaysWhereItCannotTell) {
  constexpr int D = TypeParam::value;
  ExperimentOptions o = experiment();
  o.energy.terms.own("fold_threshold") = 0.1;
  Setting<D> s(o, 0.0);
  s.weights["bending"_term] = 0;
  const GradientReport report = s.check(CheckedEnergy<D>(s.level));
  EXPECT_TRUE(report.passed()) << told(report);
  const auto state = [&](Term t) { return report.terms[static_cast<std::size_t>(t)].state; };
  EXPECT_EQ(state("match"_term), TermCheck::State::passed);
  EXPECT_EQ(state("bending"_term), TermCheck::State::off);
  EXPECT_EQ(state("volume"_term), TermCheck::State::vanishing) << told(report);
  EXPECT_EQ(state("barrier"_term), TermCheck::State::inactive);
}

TEST(GradientCheckReport, AFoldIsAnInputError) {
  Setting<2> s;
  for (Vec<2>& y : s.phi) y[0] = 1 - y[0];
  EXPECT_THROW(s.check(CheckedEnergy<2>(s.level)), InputError);
}

TEST(GradientCheckReport, JsonSaysWhatTheTextSays) {
  Setting<2> s;
  const GradientReport report = s.check(Planted<2>(s.level, "membrane"_term, Fault::one_element));
  const auto json = nlohmann::json::parse(gradient_report_json(report));
  EXPECT_EQ(json["passed"], false);
  ASSERT_EQ(json["terms"].size(), 6u);
  EXPECT_EQ(json["terms"][1]["term"], "membrane");
  EXPECT_EQ(json["terms"][1]["state"], "failed");
  EXPECT_EQ(json["terms"][1]["worst_element"]["element"], report.terms[1].worst->element);
  EXPECT_EQ(json["terms"][0]["state"], "passed");
  EXPECT_EQ(json["terms"][0]["directions"][0]["orders"].size(), 3u);
  EXPECT_NE(told(report).find("FAILED: membrane"), std::string::npos);
}

// Its matrix is kept in single precision.
TEST(GradientCheck, AModelThatIsNotFiniteIsAFault) {
  Setting<2> s;
  for (std::size_t t = 0; t < s.weights.size(); ++t) s.weights[t] = 0;
  s.weights["membrane"_term] = 1e40;
  const GradientReport report = s.check(CheckedEnergy<2>(s.level));
  EXPECT_FALSE(report.passed());
  EXPECT_NE(told(report).find("the Newton model is not finite"), std::string::npos) << told(report);
}

}  // namespace
}  // namespace shellmatch
