#include "grid/fields/interpolation.h"
#include "grid/octree/constraints.h"
#include "grid/octree/prolongation.h"
#include "grid/fields/sample.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <numeric>

namespace shellmatch {
namespace {

using test::random_grid;
using test::random_point;

template <class D>
class InterpolationTest : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(InterpolationTest, Dims);

// A conforming function with random free values.
template <int Dim>
std::vector<double> random_function(const Octree<Dim>& grid, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> nodal(grid.n_nodes());
  for (double& v : nodal) v = uniform(random);
  distribute(grid, nodal);
  return nodal;
}

TYPED_TEST(InterpolationTest, ShapeFunctionsArePositiveAndSumToOne) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const auto xi = random_point<Dim>(random);
    const auto w = shape_values<Dim>(xi);
    EXPECT_NEAR(std::accumulate(w.begin(), w.end(), 0.0), 1.0, 1e-15);
    for (const double v : w) EXPECT_GE(v, 0);
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const auto& g : shape_gradients<Dim>(xi)) sum += g;
    EXPECT_LE(sum.norm(), 1e-14);
  }
}

TYPED_TEST(InterpolationTest, ShapeFunctionsAreOneAtTheirCornerAndZeroAtTheOthers) {
  constexpr int Dim = TypeParam::value;
  for (int corner = 0; corner < n_corners<Dim>; ++corner) {
    Vec<Dim> xi;
    for (int k = 0; k < Dim; ++k) xi[k] = (corner >> k) & 1;
    const auto w = shape_values<Dim>(xi);
    for (int c = 0; c < n_corners<Dim>; ++c) EXPECT_EQ(w[c], c == corner ? 1.0 : 0.0);
  }
}

TYPED_TEST(InterpolationTest, LinearFunctionsAreExact) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 3, 0.2, 2);
  ASSERT_FALSE(grid.hanging_nodes().empty());
  Vec<Dim> slope;
  for (int k = 0; k < Dim; ++k) slope[k] = 1.5 - k;
  const auto f = [&](const Vec<Dim>& x) { return 0.25 + slope.dot(x); };
  const auto nodal = sample_nodes<Dim>(grid, f);
  EXPECT_EQ(nodal.size(), static_cast<std::size_t>(grid.n_nodes()));
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto x = random_point<Dim>(random);
    ASSERT_NEAR(evaluate<Dim>(grid, nodal, x), f(x), 1e-14);
    ASSERT_LE((evaluate_gradient<Dim>(grid, nodal, locate_local(grid, x)) - slope).norm(), 1e-12);
  }
}

TYPED_TEST(InterpolationTest, DerivativesAreThoseOfTheValues) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 2, 0.3, 4);
  const auto scalar = random_function(grid, 5);
  std::vector<Vec<Dim>> vector(grid.n_nodes());
  for (std::size_t i = 0; i < vector.size(); ++i)
    for (int k = 0; k < Dim; ++k) vector[i][k] = std::sin(7.0 * i + k);
  std::mt19937 random(6);
  for (int i = 0; i < 300; ++i) {
    auto p = locate_local<Dim>(grid, random_point<Dim>(random));
    p.xi = 0.1 * Vec<Dim>::Ones() + 0.8 * p.xi;  // differences stay within the cell
    const Vec<Dim> g = evaluate_gradient<Dim>(grid, scalar, p);
    const Mat<Dim> j = evaluate_gradient<Dim>(grid, vector, p);
    // Along each axis the functions are linear, so that central differences are exact.
    for (int k = 0; k < Dim; ++k) {
      auto up = p, down = p;
      up.xi[k] += 0.05;
      down.xi[k] -= 0.05;
      const double length = 0.1 * grid.cell(p.cell).side();
      ASSERT_NEAR((evaluate<Dim>(grid, scalar, up) - evaluate<Dim>(grid, scalar, down)) / length, g[k], 1e-10);
      const Vec<Dim> difference = evaluate<Dim>(grid, vector, up) - evaluate<Dim>(grid, vector, down);
      ASSERT_LE((difference / length - j.col(k)).norm(), 1e-10);
    }
    const auto components = evaluate_components<Dim>(grid, components_of(vector), p);
    for (int k = 0; k < Dim; ++k) ASSERT_NEAR(components[k], evaluate<Dim>(grid, vector, p)[k], 1e-15);
  }
}

// Points on every face of every leaf, hanging faces too, read from within each leaf they touch.
TYPED_TEST(InterpolationTest, FunctionsAreContinuousAcrossEveryFace) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 3, 0.2, 7);
  const auto nodal = random_function(grid, 8);
  std::mt19937 random(9);
  for (const Index leaf : grid.leaves())
    for (int face = 0; face < 2 * Dim; ++face) {
      LocalPoint<Dim> here{leaf, random_point<Dim>(random)};
      const int axis = face / 2;
      here.xi[axis] = face % 2;
      const Vec<Dim> x = grid.cell_corner(leaf) + grid.cell(leaf).side() * here.xi;
      Vec<Dim> beyond = x;
      beyond[axis] += face % 2 ? 1e-6 : -1e-6;
      LocalPoint<Dim> there;
      there.cell = grid.locate(beyond);
      there.xi = (x - grid.cell_corner(there.cell)) / grid.cell(there.cell).side();
      ASSERT_NEAR(evaluate<Dim>(grid, nodal, here), evaluate<Dim>(grid, nodal, there), 1e-12) << x.transpose();
    }
}

TYPED_TEST(InterpolationTest, PointsOutsideReadTheNearestPointOfTheDomain) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 2, 0.3, 10);
  const auto nodal = random_function(grid, 11);
  std::mt19937 random(12);
  for (int i = 0; i < 200; ++i) {
    const auto x = random_point<Dim>(random, -1, 2);
    ASSERT_EQ(evaluate<Dim>(grid, nodal, x), evaluate<Dim>(grid, nodal, Vec<Dim>(x.cwiseMax(0.0).cwiseMin(1.0))));
  }
}

TYPED_TEST(InterpolationTest, RefinementChangesNoValue) {
  constexpr int Dim = TypeParam::value;
  const auto coarse = random_grid<Dim>(2, 2, 0.3, 13);
  const auto before = random_function(coarse, 14);
  auto fine = coarse;
  for (int times = 1; times <= 2; ++times) {  // the second time over two refinements
    const Index count = fine.n_cells();
    fine.refine([&](Index leaf) { return (leaf * 7 + times) % 5 == 0; });
    ASSERT_GT(fine.n_cells(), count);
    auto after = before;
    prolongate(fine, coarse.n_nodes(), after);
    ASSERT_EQ(after.size(), static_cast<std::size_t>(fine.n_nodes()));
    auto distributed = after;
    distribute(fine, distributed);
    for (Index n = 0; n < fine.n_nodes(); ++n) ASSERT_NEAR(distributed[n], after[n], 1e-15) << "conforming";
    std::mt19937 random(15);
    for (int i = 0; i < 1000; ++i) {
      const auto x = random_point<Dim>(random);
      ASSERT_NEAR(evaluate<Dim>(coarse, before, x), evaluate<Dim>(fine, after, x), 1e-14);
    }
  }
}

TYPED_TEST(InterpolationTest, VectorFieldsAreProlongatedToo) {
  constexpr int Dim = TypeParam::value;
  auto grid = random_grid<Dim>(2, 1, 0.4, 16);
  std::vector<Vec<Dim>> identity(grid.n_nodes());
  for (Index n = 0; n < grid.n_nodes(); ++n) identity[n] = grid.node_position(n);
  const Index n_old = grid.n_nodes();
  grid.refine([](Index leaf) { return leaf % 3 == 0; });
  prolongate(grid, n_old, identity);
  for (Index n = 0; n < grid.n_nodes(); ++n) ASSERT_EQ(identity[n], grid.node_position(n));
  EXPECT_THROW(prolongate(grid, n_old, identity), std::logic_error) << "a field of another size";
}

}  // namespace
}  // namespace shellmatch
