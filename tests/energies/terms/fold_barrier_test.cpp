#include "energies/terms/fold_barrier.h"

#include "energies/autodiff/jet.h"
#include "energies/elements/element_batch.h"
#include "energies/terms/term_functors.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "tests/support/taylor.h"

#include <gtest/gtest.h>

#include <random>

#include <limits>

namespace shellmatch {
namespace {

using namespace test;

// The barrier of the unit cell compressed to `length` along the first axis: there all coefficients are
// `length`.
template <int Dim, class T>
T barrier_of(const T& length, double threshold) {
  std::array<T, n_corners<Dim> * Dim> dofs;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int k = 0; k < Dim; ++k) dofs[c * Dim + k] = T(static_cast<double>((c >> k) & 1)) * (k == 0 ? length : T(1.0));
  const double passive[] = {1 / threshold, 1, 1, threshold};
  return CornerFunctor<FoldBarrier<Dim>>::template evaluate<T, double>(dofs.data(), passive);
}

template <class T>
struct Barrier : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Barrier, Dimensions);

TYPED_TEST(Barrier, IsTheFormulaAndEndsAtTheFold) {
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
TYPED_TEST(Barrier, IsTwiceContinuouslyDifferentiableAtTheThreshold) {
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
  explicit BarrierProblem(double threshold) : problem(grid, fields, fields, with_threshold(threshold)) {}

  static ProblemOptions with_threshold(double threshold) {
    ProblemOptions o;
    o.energy.terms.own("fold_threshold") = threshold;
    return o;
  }
};

TYPED_TEST(Barrier, CostsNothingAwayFromFoldsAndGrowsTowardsThem) {
  constexpr int Dim = TypeParam::value;
  const BarrierProblem<Dim> b(0.1);
  const auto squeezed = [&](double to) {
    return at_nodes<Dim>(b.grid, [=](const Vec<Dim>& x) { return Vec<Dim>(x + (to - 1) * x[0] * Vec<Dim>::Unit(0)); });
  };
  EXPECT_EQ(b.problem.value(deformed<Dim>(b.grid, 0.03, 1), "barrier"_term), 0);
  for (const double g : b.problem.gradient(squeezed(0.11), only("barrier"_term))) EXPECT_EQ(g, 0);
  // Uniform compression: the mean of B over the whole domain is B itself, whatever the cells' sizes.
  for (const double to : {0.02, 0.05, 0.09}) {
    const double x = to / 0.1;
    EXPECT_NEAR(b.problem.value(squeezed(to), "barrier"_term), std::pow(1 - x, 3) / x, 1e-10 / x);
  }
  EXPECT_TRUE(std::isnan(b.problem.value(squeezed(-0.01), "barrier"_term)));
}

// The barrier is stricter than the volume densities: it sees folds between the quadrature points.
TYPED_TEST(Barrier, SeesWhatQuadraturePointsMiss) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(1);
  const auto fields = exact_fields<Dim>(grid, sphere<Dim>(0.3));
  ProblemOptions o;
  o.energy.terms.model("volume"_term) = "full";
  const Problem<Dim> p(grid, fields, fields, o);
  auto phi = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
  for (Index node = 0; node < grid.n_nodes(); ++node)
    if (grid.node_position(node).norm() < 1e-9) phi[node] += Vec<Dim>::Constant(Dim == 2 ? 0.28 : 0.23);
  EXPECT_TRUE(p.values(phi, only("volume"_term)).has_value());
  EXPECT_FALSE(p.values(phi, only("barrier"_term)).has_value());
}

// det Dphi itself, not that by the unit cell's coordinates.
TYPED_TEST(Barrier, TheLeastDeterminantOfAnEnlargementIsItsOwn) {
  constexpr int Dim = TypeParam::value;
  ElementBatch<Dim> batch;
  for (int lane = 0; lane < batch.n_lanes; ++lane) {
    const double side = std::ldexp(1.0, -lane);
    batch.inverse_side[lane] = 1 / side;
    for (int i = 0; i < batch.n_dofs; ++i) batch.u[i][lane] = ((i / Dim) >> (i % Dim)) & 1 ? 1.5 * side : 0.0;
  }
  for (int lane = 0; lane < batch.n_lanes; ++lane)
    EXPECT_NEAR(least_determinant(batch)[lane], std::pow(1.5, Dim), 1e-14);
}

// Of cells that are hardly bent, of such that fold, and of affine ones, where the bound is the determinant.
TYPED_TEST(Barrier, NoCoefficientIsBelowTheBoundOfAllOfThem) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> u(-1, 1);
  constexpr double side = 0.25;
  double largest_gap = 0;
  for (int trial = 0; trial < 300; ++trial) {
    ElementBatch<Dim> batch;
    batch.inverse_side = autodiff::Pack{} + 1 / side;
    const double bend = std::array{0.0, 0.003, 0.02, 0.2}[trial % 4];
    for (int lane = 0; lane < batch.n_lanes; ++lane) {
      const Mat<Dim> affine = Mat<Dim>::Identity() + 0.4 * Mat<Dim>::NullaryExpr([&] { return u(random); });
      for (int c = 0; c < n_corners<Dim>; ++c) {
        Vec<Dim> x;
        for (int k = 0; k < Dim; ++k) x[k] = (c >> k) & 1 ? side : 0.0;
        x = (affine * x).eval();
        for (int a = 0; a < Dim; ++a) batch.u[c * Dim + a][lane] = x[a] + bend * u(random);
      }
    }
    const auto bound = determinant_bound(batch), least = least_determinant(batch);
    for (int lane = 0; lane < batch.n_lanes; ++lane) {
      EXPECT_LE(bound[lane], least[lane] + 1e-13);
      if (bend == 0) {
        EXPECT_NEAR(bound[lane], least[lane], 1e-12);
      } else if (bend == 0.003) {
        largest_gap = std::max(largest_gap, least[lane] - bound[lane]);
      }
    }
  }
  EXPECT_LT(largest_gap, 0.6) << "of no use";
}

// phi = (XY, YZ, ZX) with X = 2x - 1 and so on: middles vanish, det Dphi = 16 XYZ, and the bound is reached.
TEST(BarrierBound, IsReachedWhereAllColumnsChangeTheirSigns) {
  ElementBatch<3> batch;
  batch.inverse_side = autodiff::Pack{} + 1.0;
  for (int c = 0; c < 8; ++c) {
    const double x = c & 1 ? 1 : -1, y = c & 2 ? 1 : -1, z = c & 4 ? 1 : -1;
    const std::array<double, 3> phi{x * y, y * z, z * x};
    for (int a = 0; a < 3; ++a) batch.u[c * 3 + a] = autodiff::Pack{} + phi[a];
  }
  EXPECT_EQ(least_determinant(batch)[0], -16);
  EXPECT_EQ(determinant_bound(batch)[0], -16);
}

// No coefficient changes by more than the bound that the edges give.
TYPED_TEST(Barrier, CoefficientsChangeByNoMoreThanTheBound) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    ElementBatch<Dim> here, step, there;
    here.inverse_side = step.inverse_side = there.inverse_side = autodiff::Pack{} + 4.0;
    for (int i = 0; i < here.n_dofs; ++i)
      for (int lane = 0; lane < here.n_lanes; ++lane) {
        const double identity = ((i / Dim) >> (i % Dim)) & 1 ? 0.25 : 0.0;
        here.u[i][lane] = identity + 0.1 * u(random);
        step.u[i][lane] = (trial % 2 ? 0.1 : 0.001) * u(random);
        there.u[i][lane] = here.u[i][lane] + step.u[i][lane];
      }
    const autodiff::Pack bound = determinant_change<Dim>(here.largest_entry(), step.largest_entry());
    const auto before = bernstein_determinant<Dim>(here.u.data()), after = bernstein_determinant<Dim>(there.u.data());
    for (std::size_t i = 0; i < before.size(); ++i)
      for (int lane = 0; lane < here.n_lanes; ++lane)
        EXPECT_LE(std::abs(after[i][lane] - before[i][lane]) * std::pow(4.0, Dim), bound[lane] * (1 + 1e-12));
    EXPECT_LE(std::abs(least_determinant(there)[0] - least_determinant(here)[0]), bound[0] * (1 + 1e-12));
  }
  // Signs that make a determinant large: 2 of 2 products count in the plane, 4 of 6 in space.
  ElementBatch<Dim> here, grown;
  here.inverse_side = grown.inverse_side = autodiff::Pack{} + 1.0;
  const Mat<Dim> signs = [] {
    Mat<Dim> m = Mat<Dim>::Ones();
    if (Dim == 2) m(1, 1) = -1;
    else
      for (int k = 0; k < Dim; ++k) m(k, Dim - 1 - k) = -1;
    return m;
  }();
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int a = 0; a < Dim; ++a) {
      double x = 0;
      for (int k = 0; k < Dim; ++k) x += ((c >> k) & 1) * signs(a, k);
      here.u[c * Dim + a] = autodiff::Pack{} + x;
      grown.u[c * Dim + a] = autodiff::Pack{} + 1.1 * x;
    }
  const double change =
      std::abs(bernstein_determinant<Dim>(grown.u.data())[0][0] - bernstein_determinant<Dim>(here.u.data())[0][0]);
  const double bound = determinant_change<Dim>(here.largest_entry(), autodiff::Pack{} + 0.1)[0];
  EXPECT_LE(change, bound * (1 + 1e-12));
  EXPECT_GT(change, 0.6 * bound);
  ElementBatch<Dim> one;
  one.inverse_side = autodiff::Pack{} + 4.0;
  for (int i = 0; i < one.n_dofs; ++i) one.u[i] = autodiff::Pack{} + (((i / Dim) >> (i % Dim)) & 1 ? -0.5 : 0.25);
  EXPECT_EQ(one.largest_entry()[0], 3.0);
}
}  // namespace
}  // namespace shellmatch
