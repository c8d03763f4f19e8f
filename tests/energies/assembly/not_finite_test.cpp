// A value, a gradient or a Newton model that is not finite is traced to its term, cell and point. Terms of one's own
// plant the NaN.

#include "energies/assembly/not_finite.h"
#include "energies/compiled/compile_term.h"
#include "energies/densities/material.h"
#include "energies/hessian/energy_hessian.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {
namespace {

using namespace test;

/// The square of sqrt(d2 + depth): NaN at points that phi carries deeper than that into the template.
template <int Dim>
struct NanBelowDepth : BandTerm<Dim> {
  static constexpr TermInfo info{.name = "planted", .weight = {"planted_weight", 0, {}}};
  static constexpr std::array<TermOption, 1> own{{{"planted_depth", 0.01, {}}}};
  using Density = SquareDensity<1>;
  using Reads = DependsOn<TargetDistance, OwnOptions>;
  template <class T, class P>
  constexpr SmallVec<T, 1> operator()(const T& d2, const P* options) const {
    using std::sqrt;
    SmallVec<T, 1> root;
    root[0] = sqrt(d2 + options[0]);
    return root;
  }
};

/// The size of the shear Dphi_01 as a root: 0 with a derivative of 0 times infinity where there is none.
struct RootOfShear {
  template <class T>
  using Argument = SmallMat<T, 2>;
  template <class T, class P>
  static constexpr T value(const SmallMat<T, 2>& a, const Material<P>&) {
    using std::sqrt;
    return sqrt(a(0, 1) * a(0, 1));
  }
};
struct NanGradient : CellTerm<2> {
  static constexpr TermInfo info{.name = "planted", .weight = {"planted_weight", 0, {}}};
  using Density = RootOfShear;
  using Reads = DependsOn<Dphi>;
  template <class T>
  constexpr SmallMat<T, 2> operator()(const SmallMat<T, 2>& dphi) const {
    return dphi;
  }
};

template <int Dim>
struct ShapesOfSpheres {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const Problem<Dim> problem{grid, exact_fields<Dim>(grid, sphere<Dim>(0.28)),
                             exact_fields<Dim>(grid, sphere<Dim>(0.3))};
  const std::vector<Vec<Dim>> identity = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
};

template <class T>
struct NotFiniteTest : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(NotFiniteTest, Dimensions);

TYPED_TEST(NotFiniteTest, AValueIsTracedToTermCellAndPoint) {
  constexpr int Dim = TypeParam::value;
  const ShapesOfSpheres<Dim> s;
  const auto terms = std::make_shared<EnergyTerms<Dim>>(s.problem.options);
  const double depth = 0.05;
  const Term planted = terms->add(compile_term<NanBelowDepth<Dim>>(), {depth});
  const MatchingEnergy<Dim> energy(s.problem.unknowns, s.problem.geometry, terms, s.problem.sigma, 2);
  TermValues weights(terms->size()), values;
  for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = 1;
  ASSERT_FALSE(energy.evaluate(s.identity, weights, values, {}));

  const auto found = find_not_finite<Dim>(energy, s.problem.unknowns, s.identity, weights);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->what, "value");
  EXPECT_EQ(found->term, "planted");
  ASSERT_TRUE(found->point.has_value());
  EXPECT_LT(s.problem.target.value(*found->point)[0], -depth) << "phi is the identity";
  const auto& element = s.problem.unknowns.elements()[found->element];
  EXPECT_TRUE(((*found->point - element.corner).array() > 0).all() &&
              ((*found->point - element.corner).array() < element.side).all());
  const std::string text = not_finite_text(*found);
  for (const char* part : {"the value of the term planted is not finite", "in the cell of side ", ", at the point ("})
    EXPECT_NE(text.find(part), std::string::npos) << text;

  // Without it, or where nothing lies so deep, all is finite.
  weights[planted] = 0;
  EXPECT_TRUE(energy.evaluate(s.identity, weights, values, {}));
  EXPECT_FALSE(find_not_finite<Dim>(energy, s.problem.unknowns, s.identity, weights).has_value());
}

TEST(NotFinite, AGradientIsTracedToTermCellAndPoint) {
  const ShapesOfSpheres<2> s;
  const auto terms = std::make_shared<EnergyTerms<2>>(s.problem.options);
  const Term planted = terms->add(compile_term<NanGradient>());
  const MatchingEnergy<2> energy(s.problem.unknowns, s.problem.geometry, terms, s.problem.sigma, 2);
  TermValues weights(terms->size()), values;
  weights[planted] = 1;
  auto phi = at_nodes<2>(s.grid, [](const Vec<2>& x) { return Vec<2>(x[0] + 0.1 * x[1], x[1]); });
  EXPECT_FALSE(find_not_finite<2>(energy, s.problem.unknowns, phi, weights).has_value());
  // One cell without shear.
  const std::size_t chosen = s.problem.unknowns.elements().size() / 2;
  const Element<2>& element = s.problem.unknowns.elements()[chosen];
  for (const Index node : element.nodes) phi[node] = s.identity[node];
  std::vector<double> gradient(s.problem.unknowns.size());
  ASSERT_TRUE(energy.evaluate(phi, weights, values, {}));
  energy.evaluate(phi, weights, values, gradient);
  EXPECT_TRUE(std::ranges::any_of(gradient, [](double g) { return std::isnan(g); }));
  const auto found = find_not_finite<2>(energy, s.problem.unknowns, phi, weights);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->what, "gradient");
  EXPECT_EQ(found->term, "planted");
  EXPECT_TRUE(found->point.has_value());
  EXPECT_EQ(found->element, chosen);
}

// A weight that a double holds and a float does not, which is what Newton's matrix is kept in.
TYPED_TEST(NotFiniteTest, AModelIsTracedToTermCellAndPoint) {
  constexpr int Dim = TypeParam::value;
  const ShapesOfSpheres<Dim> s;
  TermValues weights, values;
  for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = 1;
  EnergyHessian<Dim> hessian(s.problem.energy, s.problem.unknowns);
  const auto nothing = hessian.find_not_finite(s.identity, weights);
  EXPECT_FALSE(nothing.has_value()) << not_finite_text(*nothing);
  weights["match"_term] = 1e60;
  std::vector<double> gradient(s.problem.unknowns.size());
  ASSERT_TRUE(s.problem.energy.evaluate(s.identity, weights, values, gradient));
  EXPECT_TRUE(std::ranges::all_of(gradient, [](double g) { return std::isfinite(g); }));
  const auto found = hessian.find_not_finite(s.identity, weights);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->what, "Newton model");
  EXPECT_EQ(found->term, "match");
  ASSERT_TRUE(found->point.has_value());
  const auto& element = s.problem.unknowns.elements()[found->element];
  EXPECT_TRUE(((*found->point - element.corner).array() > 0).all() &&
              ((*found->point - element.corner).array() < element.side).all());

  // A term on cells is evaluated at their centres.
  weights["match"_term] = 1;
  weights["volume"_term] = 1e60;
  const auto on_cells = hessian.find_not_finite(s.identity, weights);
  ASSERT_TRUE(on_cells.has_value());
  EXPECT_EQ(on_cells->term, "volume");
  const auto& cell = s.problem.unknowns.elements()[on_cells->element];
  EXPECT_EQ(on_cells->point, Vec<Dim>(cell.corner + Vec<Dim>::Constant(cell.side / 2)));
}

}  // namespace
}  // namespace shellmatch
