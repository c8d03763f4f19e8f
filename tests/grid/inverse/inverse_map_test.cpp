#include "grid/inverse/inverse_map.h"

#include "grid/fields/interpolation.h"
#include "grid/octree/constraints.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shellmatch {
namespace {

using test::random_grid;

/// A map without folds that turns, bends and shears by much, on a grid with hanging nodes, and leaves the domain.
template <int Dim>
std::vector<Vec<Dim>> bent(const Octree<Dim>& grid) {
  std::vector<Vec<Dim>> phi(static_cast<std::size_t>(grid.n_nodes()));
  for (Index i = 0; i < grid.n_nodes(); ++i) {
    const Vec<Dim> x = grid.node_position(i);
    Vec<Dim> y = x;
    const double angle = 1.2 * x[Dim - 1] + 0.5;
    y[0] = std::cos(angle) * x[0] - std::sin(angle) * (x[1] + 0.3 * x[0] * x[0]);
    y[1] = std::sin(angle) * x[0] + std::cos(angle) * (x[1] + 0.3 * x[0] * x[0]);
    if constexpr (Dim == 2) y = Vec<2>(x[0] + 0.3 * std::sin(3 * x[1]), 1.3 * x[1] + 0.2 * x[0] * x[0]);
    phi[static_cast<std::size_t>(i)] = y;
  }
  for (const auto& h : grid.hanging_nodes()) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (int p = 0; p < h.n_parents; ++p) sum += phi[static_cast<std::size_t>(h.parents[static_cast<std::size_t>(p)])];
    phi[static_cast<std::size_t>(h.node)] = sum / h.n_parents;
  }
  return phi;
}

template <int Dim>
Vec<Dim> continued(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi, const Vec<Dim>& x) {
  const Vec<Dim> inside = x.cwiseMax(0.0).cwiseMin(1.0);
  return evaluate(grid, phi, inside) + (x - inside);
}

template <class D>
class InverseMapTest : public ::testing::Test {};
using Dims = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(InverseMapTest, Dims);

TYPED_TEST(InverseMapTest, UndoesTheMap) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 3, 0.2, 1);
  ASSERT_FALSE(grid.hanging_nodes().empty());
  const auto phi = bent<Dim>(grid);
  const InverseMap<Dim> inverse(grid, phi);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 5000; ++i) {
    Vec<Dim> x;
    for (int k = 0; k < Dim; ++k)
      x[k] = i % 3 == 0 ? std::round(8 * uniform(random)) / 8 : uniform(random);  // faces and corners, too
    const auto back = inverse(evaluate(grid, phi, x));
    ASSERT_TRUE(back) << x.transpose();
    EXPECT_LT((*back - x).norm(), 1e-11);
  }
}

TYPED_TEST(InverseMapTest, IsContinuedOutsideOfTheDomain) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 2, 0.2, 1);
  auto phi = bent<Dim>(grid);
  // Small displacements, so that the continuation is injective.
  for (Index i = 0; i < grid.n_nodes(); ++i)
    phi[static_cast<std::size_t>(i)] = 0.9 * grid.node_position(i) + 0.1 * phi[static_cast<std::size_t>(i)];
  const InverseMap<Dim> inverse(grid, phi);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 2);
  for (int i = 0; i < 3000; ++i) {
    Vec<Dim> x;
    for (int k = 0; k < Dim; ++k) x[k] = uniform(random);
    const auto back = inverse(continued<Dim>(grid, phi, x));
    ASSERT_TRUE(back) << x.transpose();
    EXPECT_LT((*back - x).norm(), 1e-11) << x.transpose();
  }
}

TEST(InverseMap, FindsPreimagesInACellThatNewtonsMethodLeaves) {
  // A single cell with one corner pushed nearly to the opposite diagonal: the Jacobian almost vanishes there.
  const Octree<2> grid(0);
  std::vector<Vec<2>> phi(4);
  for (Index i = 0; i < 4; ++i) {
    const Vec<2> x = grid.node_position(i);
    phi[static_cast<std::size_t>(i)] = x.sum() > 1.5 ? Vec<2>(0.501, 0.501) : x;
  }
  const InverseMap<2> inverse(grid, phi);
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      const Vec<2> x(i / 40.0, j / 40.0);
      const auto back = inverse(evaluate(grid, phi, x));
      ASSERT_TRUE(back) << x.transpose();
      EXPECT_LT((evaluate(grid, phi, *back) - evaluate(grid, phi, x)).norm(), 1e-12) << x.transpose();
    }
}

TEST(InverseMap, SaysSoWhereThereIsNoPreimage) {
  // The whole boundary goes to one point: nothing but that is reached from outside.
  const Octree<2> grid(1);
  const std::vector<Vec<2>> phi(static_cast<std::size_t>(grid.n_nodes()), Vec<2>(0.5, 0.5));
  const InverseMap<2> inverse(grid, phi);
  const auto x = inverse(Vec<2>(0.6, 0.5));
  EXPECT_TRUE(!x || (continued<2>(grid, phi, *x) - Vec<2>(0.6, 0.5)).norm() < 1e-12);
  EXPECT_FALSE(inverse(Vec<2>(std::nan(""), 0.5)));
}

}  // namespace
}  // namespace shellmatch
