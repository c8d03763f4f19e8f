#include "energies/fold_barrier.h"

#include "energies/autodiff/jet.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "tests/support/taylor.h"

#include <gtest/gtest.h>

#include <limits>

namespace shellmatch {
namespace {

using namespace test;

// The barrier of the unit cell compressed to `length` along the first axis: there all coefficients are `length`.
template <int Dim, class T>
T barrier_of(const T& length, double threshold) {
  std::array<T, n_corners<Dim> * Dim> dofs;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int k = 0; k < Dim; ++k) dofs[c * Dim + k] = T(static_cast<double>((c >> k) & 1)) * (k == 0 ? length : T(1.0));
  const double scale = 1 / threshold;
  return FoldBarrierFunctor<Dim>::template evaluate<T, double>(dofs.data(), &scale);
}

template <class T>
struct FoldBarrier : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(FoldBarrier, Dimensions);

TYPED_TEST(FoldBarrier, IsTheFormulaAndEndsAtTheFold) {
  constexpr int Dim = TypeParam::value;
  const double d0 = 0.3;
  for (const double x : {0.01, 0.1, 0.5, 0.9, 0.999})
    EXPECT_NEAR(barrier_of<Dim>(x * d0, d0), std::pow(1 - x, 3) / x, 1e-12 / x);
  for (const double x : {1 + 1e-12, 1.001, 2.0, 100.0}) EXPECT_EQ(barrier_of<Dim>(x * d0, d0), 0);
  EXPECT_GT(barrier_of<Dim>(1e-12, d0), 1e10);
  EXPECT_FALSE(std::isfinite(barrier_of<Dim>(0.0, d0)));
  for (const double folded : {-1e-9, -0.1, -5.0}) EXPECT_TRUE(std::isnan(barrier_of<Dim>(folded, d0)));
}

// Value, slope and curvature vanish together at the threshold: as (1 - x)^3, (1 - x)^2 and 1 - x.
TYPED_TEST(FoldBarrier, IsTwiceContinuouslyDifferentiableAtTheThreshold) {
  constexpr int Dim = TypeParam::value;
  const double d0 = 0.3;
  using Jet = ceres::Jet<double, 1>;
  const auto slope = [&](double x) { return barrier_of<Dim>(Jet(x * d0, 0), d0).v[0]; };
  const auto order = [](auto&& f) { return order_between(1e-2, std::abs(f(1e-2)), 1e-3, std::abs(f(1e-3))); };
  EXPECT_NEAR(order([&](double gap) { return barrier_of<Dim>((1 - gap) * d0, d0); }), 3, 0.05);
  EXPECT_NEAR(order([&](double gap) { return slope(1 - gap); }), 2, 0.05);
  EXPECT_NEAR(order([&](double gap) { return slope(1 - 1.01 * gap) - slope(1 - 0.99 * gap); }) - 1, 1, 0.05);
  for (const double beyond : {1.0 + 1e-12, 1.1, 3.0}) EXPECT_EQ(slope(beyond), 0);
}

template <int Dim>
struct BarrierProblem {
  Octree<Dim> grid = hanging_grid<Dim>(0.28);
  CoefficientFields<Dim> fields = exact_fields<Dim>(grid, sphere<Dim>(0.28));
  Problem<Dim> problem;
  explicit BarrierProblem(double threshold) : problem(grid, fields, fields, {.energy = {.fold_threshold = threshold}}) {}
};

TYPED_TEST(FoldBarrier, CostsNothingAwayFromFoldsAndGrowsTowardsThem) {
  constexpr int Dim = TypeParam::value;
  const BarrierProblem<Dim> b(0.1);
  const auto squeezed = [&](double to) {
    return at_nodes<Dim>(b.grid, [=](const Vec<Dim>& x) { return Vec<Dim>(x + (to - 1) * x[0] * Vec<Dim>::Unit(0)); });
  };
  EXPECT_EQ(b.problem.value(deformed<Dim>(b.grid, 0.03, 1), Term::barrier), 0);
  for (const double g : b.problem.gradient(squeezed(0.11), only(Term::barrier))) EXPECT_EQ(g, 0);
  // Uniform compression: the mean of B over the whole domain is B itself, whatever the cells' sizes.
  for (const double to : {0.02, 0.05, 0.09}) {
    const double x = to / 0.1;
    EXPECT_NEAR(b.problem.value(squeezed(to), Term::barrier), std::pow(1 - x, 3) / x, 1e-10 / x);
  }
  EXPECT_TRUE(std::isnan(b.problem.value(squeezed(-0.01), Term::barrier)));
}

// The barrier is stricter than the volume densities: it sees folds between the quadrature points.
TYPED_TEST(FoldBarrier, SeesWhatQuadraturePointsMiss) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(1);
  const auto fields = exact_fields<Dim>(grid, sphere<Dim>(0.3));
  ProblemOptions o{.energy = {.volume = VolumeDensity::full}};
  const Problem<Dim> p(grid, fields, fields, o);
  auto phi = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
  for (Index node = 0; node < grid.n_nodes(); ++node)
    if (grid.node_position(node).norm() < 1e-9) phi[node] += Vec<Dim>::Constant(Dim == 2 ? 0.28 : 0.23);
  EXPECT_TRUE(p.values(phi, only(Term::volume)).has_value());
  EXPECT_FALSE(p.values(phi, only(Term::barrier)).has_value());
}

}  // namespace
}  // namespace shellmatch
