// Terms that read fields of the user's own, at nodes, cells and quadrature points, and phi itself: value, gradient by
// both evaluators, derivative, and Newton's model. And what the terms of the list say that they read.

#include "energies/assembly/ceres_evaluator.h"
#include "energies/compiled/compile_term.h"
#include "energies/hessian/energy_hessian.h"
#include "docs/examples/own_fields.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "tests/energies/terms/term_types.h"
#include "tests/support/taylor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace shellmatch {
namespace {

using namespace test;

/// A term of the band that reads phi, a field of the template and two fields of one's own: |w n2 . (phi - phi0)|^2.
template <int Dim>
struct InBand : BandTerm<Dim> {
  struct Origin : OwnField<Dim> {};
  struct Factor : OwnField<1> {};
  static constexpr TermInfo info{.name = "in_band"};
  using Density = SquareDensity<1>;
  using Reads = DependsOn<Factor, Phi, TargetNormal, Origin>;
  template <class T, class P>
  constexpr SmallVec<T, 1> operator()(const SmallVec<P, 1>& w, const SmallVec<T, Dim>& phi, const SmallVec<T, Dim>& n2,
                                      const SmallVec<P, Dim>& origin) const {
    T sum = n2[0] * (phi[0] - origin[0]);
    for (int i = 1; i < Dim; ++i) sum = sum + n2[i] * (phi[i] - origin[i]);
    return {{w[0] * sum}};
  }
};

std::shared_ptr<const UserField> random_field(UserField::Place place, int n_components, std::size_t n_places) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  UserField field{place, n_components, {}};
  for (std::size_t i = 0; i < n_places * static_cast<std::size_t>(n_components); ++i)
    field.values.push_back(uniform(random));
  return std::make_shared<const UserField>(std::move(field));
}

template <int Dim>
struct WithOwnFields {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  Problem<Dim> problem;
  std::shared_ptr<EnergyTerms<Dim>> terms;
  std::vector<Term> own;
  std::optional<MatchingEnergy<Dim>> energy;
  const std::vector<Vec<Dim>> phi = deformed<Dim>(grid, 0.03, 11);

  explicit WithOwnFields(Evaluator evaluator)
      : problem(grid, exact_fields<Dim>(grid, sphere<Dim>(0.28)),
                exact_fields<Dim>(grid, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24))), options(evaluator)) {
    terms = std::make_shared<EnergyTerms<Dim>>(problem.options);
    using Place = UserField::Place;
    const std::size_t n_elements = problem.unknowns.elements().size(), n_points = n_elements * (1 << Dim);
    const auto n_nodes = static_cast<std::size_t>(grid.n_nodes());
    own.push_back(
        terms->add(compile_term<example::NearRotation<Dim>>(), {}, {random_field(Place::points, Dim * Dim, n_points)}));
    own.push_back(terms->add(compile_term<example::NearMap<Dim>>(), {},
                             {random_field(Place::nodes, Dim, n_nodes), random_field(Place::cells, 1, n_elements)}));
    own.push_back(terms->add(compile_term<InBand<Dim>>(), {},
                             {random_field(Place::cells, 1, n_elements), random_field(Place::nodes, Dim, n_nodes)}));
    energy.emplace(problem.unknowns, problem.geometry, terms, problem.sigma, 2);
  }
  static ProblemOptions options(Evaluator evaluator) {
    ProblemOptions o;
    o.smooth = true;
    o.energy.evaluator = evaluator;
    return o;
  }
  TermValues weights(Term term) const {
    TermValues w(terms->size());
    w[term] = 0.7;
    return w;
  }
  double value(const std::vector<Vec<Dim>>& at, const TermValues& w, std::span<double> gradient = {}) const {
    TermValues values;
    EXPECT_TRUE(energy->evaluate(at, w, values, gradient));
    return values.sum();
  }
};

template <class T>
struct OwnFields : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(OwnFields, Dimensions);

TYPED_TEST(OwnFields, AreReadByBothEvaluatorsAlike) {
  constexpr int Dim = TypeParam::value;
  const WithOwnFields<Dim> compiled(Evaluator::compiled), by_ceres(Evaluator::ceres);
  for (const Term term : compiled.own) {
    std::vector<double> g(compiled.problem.unknowns.size()), h = g;
    const double value = compiled.value(compiled.phi, compiled.weights(term), g);
    EXPECT_GT(value, 1e-3);
    EXPECT_NEAR(by_ceres.value(compiled.phi, compiled.weights(term), h), value, 1e-12 * value);
    double size = 0, error = 0;
    for (std::size_t i = 0; i < g.size(); ++i) {
      size = std::max(size, std::abs(g[i]));
      error = std::max(error, std::abs(g[i] - h[i]));
    }
    EXPECT_GT(size, 0);
    EXPECT_LT(error, 1e-12 * size);
  }
}

TYPED_TEST(OwnFields, HaveDerivativesAndAModelOfGaussAndNewton) {
  constexpr int Dim = TypeParam::value;
  const WithOwnFields<Dim> a(Evaluator::compiled);
  const auto direction = at_nodes<Dim>(a.grid, smooth_field<Dim>(3));
  std::vector<double> v(a.problem.unknowns.size()), g = v, hv = v;
  a.problem.unknowns.restrict_to(direction, v);
  for (const Term term : a.own) {
    SCOPED_TRACE(a.terms->names()[static_cast<std::size_t>(term)]);
    const TermValues weights = a.weights(term);
    a.value(a.phi, weights, g);
    const auto line = [&](double t) {
      auto moved = a.phi;
      for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += t * direction[i];
      return a.value(moved, weights);
    };
    const double slope = std::inner_product(g.begin(), g.end(), v.begin(), 0.0);
    EXPECT_TRUE(has_derivative(line, slope));
    EXPECT_FALSE(has_derivative(line, 1.01 * slope));
    // Terms that are quadratic in phi have their second derivative as their model.
    if (term == a.own.back()) continue;
    EnergyHessian<Dim> hessian(*a.energy, a.problem.unknowns);
    hessian.assemble(a.phi, weights);
    hessian.apply(v, hv);
    const double h = 0.1, second = (line(h) - 2 * line(0) + line(-h)) / (h * h);
    EXPECT_NEAR(std::inner_product(v.begin(), v.end(), hv.begin(), 0.0), second, 1e-5 * second);
  }
}

TYPED_TEST(OwnFields, MayChangeBetweenEvaluationsAndHaveToFit) {
  constexpr int Dim = TypeParam::value;
  const WithOwnFields<Dim> a(Evaluator::compiled);
  const auto& elements = a.problem.unknowns.elements();
  const auto field = std::make_shared<UserField>(UserField{UserField::Place::cells, Dim * Dim, {}});
  const auto terms = std::make_shared<EnergyTerms<Dim>>(a.problem.options);
  const Term term = terms->add(compile_term<example::NearRotation<Dim>>(), {}, {field});
  const auto make = [&] {
    return MatchingEnergy<Dim>(a.problem.unknowns, a.problem.geometry, terms, a.problem.sigma, 2);
  };
  EXPECT_ANY_THROW(make()) << "no values";
  EXPECT_ANY_THROW(terms->add(compile_term<example::NearMap<Dim>>(), {}, {field})) << "other components";
  field->values.assign(elements.size() * Dim * Dim, 0.0);
  const auto energy = make();
  TermValues weights(terms->size()), values;
  weights[term] = 1;
  const auto identity = at_nodes<Dim>(a.grid, [](const Vec<Dim>& x) { return x; });
  ASSERT_TRUE(energy.evaluate(identity, weights, values, {}));
  EXPECT_NEAR(values.sum(), Dim, 1e-12);  // |I|^2
  for (std::size_t i = 0; i < field->values.size(); ++i) field->values[i] = i % (Dim * Dim) % (Dim + 1) == 0;
  ASSERT_TRUE(energy.evaluate(identity, weights, values, {}));
  EXPECT_NEAR(values.sum(), 0, 1e-12);
}

/// Does the compiled code read the fields that the term names, and no others?
template <class Term>
void check_reads() {
  if constexpr (!IsCornerTerm<Term>) {
    SCOPED_TRACE(TermTestNames::GetName<Term>(0));
    using Reads = typename Term::Reads;
    using Code = autodiff::Compiled<PointFunctor<Term>>;
    constexpr int dim = Term::dim, n_target = IsBandTerm<Term> ? TargetPoint<dim, double>::size : 0;
    const auto read = []<std::size_t... I>(std::index_sequence<I...>) {
      return std::array<bool, sizeof...(I)>{Code::reads_active(static_cast<int>(I))...};
    }
    (std::make_index_sequence<Code::n_active>{});
    const auto any = [&](int begin, int end) {
      return std::any_of(read.begin() + begin, read.begin() + end, [](bool b) { return b; });
    };
    EXPECT_EQ(any(n_target, n_target + dim * dim), (Reads::template has<Dphi>));
    if constexpr (IsBandTerm<Term>) {
      EXPECT_EQ(any(0, 1), (Reads::template has<TargetDistance>));
      EXPECT_EQ(any(1, 1 + dim), (Reads::template has<TargetNormal>));
      EXPECT_EQ(any(1 + dim, n_target), (Reads::template has<TargetRoot, TargetShapeOperator>));
    }
  }
}

TEST(Reads, AreWhatTheTermsRead) {
  for_each_term(AllTerms<2>{}, []<class Term>() { check_reads<Term>(); });
  for_each_term(AllTerms<3>{}, []<class Term>() { check_reads<Term>(); });
}

}  // namespace
}  // namespace shellmatch
