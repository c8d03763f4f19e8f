#include "grid/fits/local_fit.h"

#include "base/parallel.h"
#include "grid/fields/sample.h"
#include "grid/fits/nearest_nodes.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using test::random_grid;

template <class D>
class LocalFitTest : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(LocalFitTest, Dims);

template <int Dim>
Mat<Dim> some_hessian(double seed) {
  Mat<Dim> a;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j <= i; ++j) a(i, j) = a(j, i) = std::cos(seed + 3 * i + 5 * j);
  return a;
}

template <int Dim>
std::vector<double> quadratic(const Octree<Dim>& grid, const Mat<Dim>& hessian) {
  Vec<Dim> slope;
  for (int k = 0; k < Dim; ++k) slope[k] = 0.3 - k;
  return sample_nodes<Dim>(grid, [&](const Vec<Dim>& x) { return 5 + slope.dot(x) + 0.5 * x.dot(hessian * x); });
}

// Also with fewer neighbours than a quadratic has coefficients: the neighbourhood grows until it is
// determined.
TYPED_TEST(LocalFitTest, ExactForQuadraticsOnAllGrids) {
  constexpr int Dim = TypeParam::value;
  const Mat<Dim> expected = some_hessian<Dim>(1);
  for (const auto& grid :
       {Octree<Dim>(1), Octree<Dim>(3), random_grid<Dim>(2, 3, 0.15, 1), random_grid<Dim>(1, 4, 0.3, 2)})
    for (const int neighbours : {0, 3, 40})
      for (const double weight : {0.0, 2.0}) {
        CoefficientOptions options;
        options.neighbours = neighbours;
        options.fit_weight = weight;
        const auto hessians = fit_hessians<Dim>(grid, quadratic(grid, expected), options, grid.free_nodes());
        ASSERT_EQ(hessians.size(), grid.free_nodes().size());
        for (const auto& h : hessians)
          ASSERT_LE((unpack_symmetric<Dim>(h) - expected).norm(), 1e-13 * std::pow(4.0, grid.finest_level() + 2));
      }
}

// By ascending position: versions of the library find equally near nodes in other orders, in which sums would have
// other bits.
TYPED_TEST(LocalFitTest, NearestNodesAreThoseOfASearchInTheirOrder) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 3, 0.3, 4);
  const auto free = grid.free_nodes();
  const NearestNodes<Dim> nodes(grid);
  typename NearestNodes<Dim>::Scratch scratch;
  for (const std::size_t n : {std::size_t{1}, std::size_t{12}, std::size_t{40}})
    for (std::size_t i = 0; i < free.size(); i += 7) {
      std::array<double, Dim> centre;
      for (int k = 0; k < Dim; ++k) centre[k] = grid.node_coord(free[i])[k];
      const auto square_to = [&](Index node) {
        double sum = 0;
        for (int k = 0; k < Dim; ++k) sum += std::pow(grid.node_coord(node)[k] - centre[k], 2);
        return sum;
      };
      std::vector<double> squares;
      for (const Index node : free) squares.push_back(square_to(node));
      std::ranges::sort(squares);
      const auto [nearest, farthest] = nodes.find(centre, n, scratch);
      EXPECT_EQ(nearest, squares[1]);
      EXPECT_EQ(farthest, squares[n]);
      std::vector<Index> expected, found;
      for (std::size_t k = 0; k < free.size(); ++k)
        if (square_to(free[k]) <= farthest) expected.push_back(static_cast<Index>(k));
      for (const auto& [position, square] : scratch.ball) {
        found.push_back(position);
        EXPECT_EQ(square, square_to(free[position]));
      }
      ASSERT_EQ(found, expected);
    }
}

TYPED_TEST(LocalFitTest, TwoFieldsAtOnceAreThoseFieldsEach) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 2, 0.3, 3);
  const std::array fields{sample_nodes<Dim>(grid, [](const Vec<Dim>& x) { return std::sin(4 * x[0] * x[1]); }),
                          sample_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x.norm(); })};
  const auto both = fit_hessians<Dim>(grid, fields, {}, grid.free_nodes());
  for (int f = 0; f < 2; ++f) {
    const auto alone = fit_hessians<Dim>(grid, fields[f], {}, grid.free_nodes());
    for (std::size_t i = 0; i < alone.size(); ++i)
      for (std::size_t k = 0; k < alone[i].size(); ++k) ASSERT_NEAR(both[f][i][k], alone[i][k], 1e-9);
  }
}

// The neighbourhood consists of whole shells, so that mirroring the field mirrors the result.
TYPED_TEST(LocalFitTest, HasTheSymmetriesOfTheGrid) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(3);
  const auto f = [](const Vec<Dim>& x) { return std::exp(x[0]) * std::sin(2 * x[1]) + x[Dim - 1] * x[0] * x[0]; };
  CoefficientOptions options;
  options.neighbours = 10;  // cuts into a shell in the plane and in space
  const auto here = fit_hessians<Dim>(grid, sample_nodes<Dim>(grid, f), options, grid.free_nodes());
  const auto mirrored = sample_nodes<Dim>(grid, [&](Vec<Dim> x) {
    x[0] = 1 - x[0];
    return f(x);
  });
  const auto there = fit_hessians<Dim>(grid, mirrored, options, grid.free_nodes());
  for (const Index node : grid.free_nodes()) {
    auto image = grid.node_coord(node);
    image[0] = (1 << Octree<Dim>::max_level) - image[0];
    const auto& a = here[grid.free_index(node)];
    const auto& b = there[grid.free_index(grid.find_node(image))];
    ASSERT_NEAR(a[0], b[0], 1e-10);   // xx
    ASSERT_NEAR(a[1], -b[1], 1e-10);  // xy
  }
}

TYPED_TEST(LocalFitTest, OnlyAtTheNodesAskedFor) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 2, 0.3, 4);
  const auto field = sample_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x.squaredNorm() * x[0]; });
  const auto all = fit_hessians<Dim>(grid, field, {}, grid.free_nodes());
  const std::vector<Index> some{grid.free_nodes()[7], grid.free_nodes()[2]};
  const auto few = fit_hessians<Dim>(grid, field, {}, some);
  ASSERT_EQ(few.size(), 2u);
  EXPECT_EQ(few[0], all[7]);
  EXPECT_EQ(few[1], all[2]);
  ASSERT_FALSE(grid.hanging_nodes().empty());
  const std::vector<Index> hanging{grid.hanging_nodes()[0].node};
  EXPECT_THROW(fit_hessians<Dim>(grid, field, {}, hanging), std::logic_error);
}

TYPED_TEST(LocalFitTest, RefusesAGridWithoutEnoughNodes) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(0);
  EXPECT_THROW(fit_hessians<Dim>(grid, std::vector<double>(grid.n_nodes()), {}, grid.free_nodes()), std::logic_error);
}

TYPED_TEST(LocalFitTest, SameBitsWithOneAndTwoThreads) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(Dim == 2 ? 5 : 3, 2, 0.3, 5);
  const auto field = sample_nodes<Dim>(grid, [](const Vec<Dim>& x) { return std::sin(9 * x[0]) * x[1]; });
  set_n_threads(1);
  const auto one = fit_hessians<Dim>(grid, field, {}, grid.free_nodes());
  set_n_threads(2);
  EXPECT_EQ(one, fit_hessians<Dim>(grid, field, {}, grid.free_nodes()));
}

}  // namespace
}  // namespace shellmatch
