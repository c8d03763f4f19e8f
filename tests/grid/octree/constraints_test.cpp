#include "grid/octree/constraints.h"

#include "base/parallel.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <numeric>

namespace shellmatch {
namespace {

using test::random_grid;

template <class D>
class ConstraintsTest : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ConstraintsTest, Dims);

std::vector<double> random_vector(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> v(n);
  for (double& x : v) x = uniform(random);
  return v;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// <C x, y> = <x, C^T y>
TYPED_TEST(ConstraintsTest, CondensationIsTheTransposeOfExpansion) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 3, 0.2, 1);
  const Constraints<Dim> c(grid);
  for (const int n : {1, Dim, 6}) {
    const auto x = random_vector(c.n_free() * n, 2), y = random_vector(std::size_t(grid.n_nodes()) * n, 3);
    std::vector<double> cx(y.size()), cty(x.size()), picked(x.size());
    c.expand(x, cx, n);
    c.condense(std::span<const double>(y), cty, n);
    EXPECT_NEAR(dot(cx, y), dot(x, cty), 1e-11);
    c.pick(cx, picked, n);
    EXPECT_EQ(picked, x);
    auto in_place = y;
    c.condense(std::span<double>(in_place), n);
    c.pick(in_place, picked, n);
    EXPECT_EQ(picked, cty);
    for (const auto& h : grid.hanging_nodes())
      for (int k = 0; k < n; ++k) EXPECT_EQ(in_place[std::size_t(h.node) * n + k], 0.0);
  }
}

TYPED_TEST(ConstraintsTest, DistributionIsAProjection) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 3, 0.2, 4);
  auto once = random_vector(grid.n_nodes(), 5);
  const auto before = once;
  distribute(grid, once);
  EXPECT_NE(once, before);
  for (const Index n : grid.free_nodes()) EXPECT_EQ(once[n], before[n]);
  auto twice = once;
  distribute(grid, twice);
  EXPECT_EQ(once, twice);
}

TYPED_TEST(ConstraintsTest, VectorFieldsAndTheirComponentsAgree) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 2, 0.3, 6);
  std::vector<Vec<Dim>> field(grid.n_nodes());
  for (Index n = 0; n < grid.n_nodes(); ++n) field[n] = grid.node_position(n);
  for (const auto& h : grid.hanging_nodes()) field[h.node].setConstant(99);
  distribute(grid, field);
  for (Index n = 0; n < grid.n_nodes(); ++n) ASSERT_EQ(field[n], grid.node_position(n));
}

TYPED_TEST(ConstraintsTest, SameBitsWithOneAndTwoThreads) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(Dim == 2 ? 5 : 3, 2, 0.3, 7);
  const Constraints<Dim> c(grid);
  const auto y = random_vector(grid.n_nodes(), 8);
  std::vector<double> one(c.n_free()), two(c.n_free());
  set_n_threads(1);
  c.condense(std::span<const double>(y), one);
  set_n_threads(2);
  c.condense(std::span<const double>(y), two);
  EXPECT_EQ(one, two);
}

TYPED_TEST(ConstraintsTest, RefusesFieldsOfAnotherSize) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(2);
  std::vector<double> wrong(3);
  EXPECT_THROW(distribute(grid, wrong), std::logic_error);
}

TEST(SymmetricComponents, PackAndUnpackAreInverse) {
  Mat<3> a;
  a << 1, 2, 3, 2, 4, 5, 3, 5, 6;
  EXPECT_EQ(pack_symmetric<3>(a), (SymmetricComponents<3>{1, 2, 3, 4, 5, 6})) << "xx, xy, xz, yy, yz, zz";
  EXPECT_EQ(unpack_symmetric<3>(pack_symmetric<3>(a)), a);
}

}  // namespace
}  // namespace shellmatch
