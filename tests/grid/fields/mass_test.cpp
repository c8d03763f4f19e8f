#include "grid/fields/mass.h"

#include "base/parallel.h"
#include "grid/fields/interpolation.h"
#include "grid/fields/quadrature.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <numeric>

namespace shellmatch {
namespace {

using test::random_grid;

template <class D>
class MassTest : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(MassTest, Dims);

template <int Dim>
std::vector<double> wave(std::size_t n, double frequency) {
  std::vector<double> v(n);
  for (std::size_t i = 0; i < n; ++i) v[i] = std::sin(frequency * (i + 1));
  return v;
}

TYPED_TEST(MassTest, LumpedMassIsPositiveAndSumsToTheVolume) {
  constexpr int Dim = TypeParam::value;
  for (const auto& grid : {Octree<Dim>(0), Octree<Dim>(3), random_grid<Dim>(2, 3, 0.2, 1)}) {
    const auto mass = lumped_mass(grid);
    ASSERT_EQ(mass.size(), grid.free_nodes().size());
    for (const double m : mass) EXPECT_GT(m, 0);
    EXPECT_NEAR(std::accumulate(mass.begin(), mass.end(), 0.0), 1, 1e-13);
  }
}

TYPED_TEST(MassTest, LumpedMassIsTheRowSumOfTheConsistentOne) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 3, 0.2, 2);
  const MassOperator<Dim> mass(grid);
  std::vector<double> ones(grid.free_nodes().size(), 1.0), rows(ones.size());
  mass.apply(ones, rows);
  const auto lumped = lumped_mass(grid);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_NEAR(rows[i], lumped[i], 1e-16);
}

// x^T M y is the integral of the product of the functions, which two Gauss points per direction give exactly.
TYPED_TEST(MassTest, ConsistentMassIsTheProductOfFunctions) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 2, 0.3, 3);
  const MassOperator<Dim> mass(grid);
  const std::size_t n = grid.free_nodes().size();
  const auto x = wave<Dim>(n, 0.7), y = wave<Dim>(n, 1.3);
  std::vector<double> my(n), fx(grid.n_nodes()), fy(grid.n_nodes());
  mass.apply(y, my);
  mass.constraints().expand(x, fx);
  mass.constraints().expand(y, fy);
  double integral = 0;
  for (const Index leaf : grid.leaves())
    for (const auto& q : gauss_rule<Dim>(2)) {
      const LocalPoint<Dim> p{leaf, q.point};
      integral +=
          std::pow(grid.cell(leaf).side(), Dim) * q.weight * evaluate<Dim>(grid, fx, p) * evaluate<Dim>(grid, fy, p);
    }
  EXPECT_NEAR(std::inner_product(x.begin(), x.end(), my.begin(), 0.0), integral, 1e-14);
}

TYPED_TEST(MassTest, SolveInvertsApply) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 3, 0.2, 4);
  const MassOperator<Dim> mass(grid);
  const auto x = wave<Dim>(grid.free_nodes().size() * Dim, 0.9);
  std::vector<double> b(x.size()), solution(x.size(), 0.0);
  mass.apply(x, b, Dim);
  const int iterations = mass.solve(b, solution, Dim, 1e-12);
  EXPECT_LT(iterations, 100);
  for (std::size_t i = 0; i < x.size(); ++i) ASSERT_NEAR(solution[i], x[i], 1e-9);
  EXPECT_EQ(mass.solve(b, solution, Dim, 1e-6), 0) << "a good start needs no step";
}

TYPED_TEST(MassTest, SameBitsWithOneAndTwoThreads) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(Dim == 2 ? 5 : 3, 2, 0.3, 5);
  const auto b = wave<Dim>(grid.free_nodes().size(), 0.9);
  std::array<std::vector<double>, 2> solutions;
  for (int t = 0; t < 2; ++t) {
    set_n_threads(t + 1);
    solutions[t].assign(b.size(), 0.0);
    MassOperator<Dim>(grid).solve(b, solutions[t], 1, 1e-10);
  }
  EXPECT_EQ(solutions[0], solutions[1]);
}

}  // namespace
}  // namespace shellmatch
