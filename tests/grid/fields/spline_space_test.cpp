#include "grid/fields/spline_coefficients.h"

#include "grid/fields/interpolation.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

/// A scalar function of the space, evaluated from the definition.
template <int Dim>
class Function {
 public:
  Function(const SplineSpace<Dim>& space, const std::vector<double>& nodal, std::size_t n_quasi_interpolated = 1)
      : space_(space), coefficients_(space.n_coefficients(), 0.0) {
    const auto at_node = [&](Index node, std::size_t) { return nodal[node]; };
    const auto at = [&](Index c, std::size_t) -> double& { return coefficients_[c]; };
    if (n_quasi_interpolated == 1) space.template coefficients<1, 1>(at_node, at);
    else space.template coefficients<1, 0>(at_node, at);
  }

  /// Value and gradient of the leaf's polynomial at x, which need not lie in the leaf.
  std::pair<double, Vec<Dim>> of_leaf(Index leaf, const Vec<Dim>& x) const {
    const double side = std::ldexp(1.0, -space_.level_of(leaf));
    Vec<Dim> t = x / side;
    for (int k = 0; k < Dim; ++k) t[k] -= space_.corner_of(leaf)[k];
    const auto local = space_.coefficients_of(leaf);
    double value = 0;
    Vec<Dim> gradient = Vec<Dim>::Zero();
    for (int n = 0; n < SplineSpace<Dim>::n_local; ++n) {
      const double c = coefficients_[local[n]];
      for (int derived = -1; derived < Dim; ++derived) {
        double product = c;
        for (int k = 0, rest = n; k < Dim; ++k, rest /= 3) {
          const SplineWeights<double> w(t[k]);
          product *= k == derived ? w.slope[rest % 3] / side : w.value[rest % 3];
        }
        (derived < 0 ? value : gradient[derived]) += product;
      }
    }
    return {value, gradient};
  }
  double operator()(const Vec<Dim>& x) const { return of_leaf(space_.locate(x), x).first; }

 private:
  const SplineSpace<Dim>& space_;
  std::vector<double> coefficients_;
};

template <int Dim>
std::vector<double> values(const Octree<Dim>& grid, const auto& f) {
  std::vector<double> v;
  for (Index i = 0; i < grid.n_nodes(); ++i) v.push_back(f(grid.node_position(i)));
  return v;
}

template <class T>
struct Splines : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Splines, Dimensions);

// Any values at all: on faces between leaves of all sizes both polynomials have one value and one gradient.
TYPED_TEST(Splines, AreContinuouslyDifferentiable) {
  constexpr int Dim = TypeParam::value;
  for (const unsigned seed : {1u, 2u}) {
    const Octree<Dim> grid = random_grid<Dim>(1, Dim == 2 ? 5 : 3, 0.4, seed);
    ASSERT_FALSE(grid.hanging_nodes().empty());
    const SplineSpace<Dim> space(grid);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const Function<Dim> f(space, values<Dim>(grid, [&](const Vec<Dim>&) { return normal(random); }));
    int n_between_levels = 0;
    for (const Index cell : grid.leaves()) {
      const double side = grid.cell(cell).side();
      const Index leaf = space.locate(grid.cell_centre(cell));
      for (int face = 0; face < 2 * Dim; ++face) {
        Vec<Dim> x = grid.cell_corner(cell) + side * random_point<Dim>(random);
        x[face / 2] = grid.cell_corner(cell)[face / 2] + (face % 2) * side;
        Vec<Dim> beyond = x;
        beyond[face / 2] += face % 2 ? 1e-9 : -1e-9;
        if (beyond[face / 2] < 0 || beyond[face / 2] > 1) continue;
        const auto [a, gradient_a] = f.of_leaf(leaf, x);
        const auto [b, gradient_b] = f.of_leaf(space.locate(beyond), x);
        n_between_levels += grid.cell(grid.locate(beyond)).level != grid.cell(cell).level;
        EXPECT_NEAR(a, b, 1e-12);
        EXPECT_LT((gradient_a - gradient_b).norm(), 1e-11 / side);
      }
    }
    EXPECT_GT(n_between_levels, 10);
  }
}

TYPED_TEST(Splines, ReproduceLinearFunctionsEverywhere) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid = random_grid<Dim>(1, 3, 0.4, 5);
  const SplineSpace<Dim> space(grid);
  const Vec<Dim> slope = Vec<Dim>::LinSpaced(0.7, -1.3);
  const Function<Dim> f(space, values<Dim>(grid, [&](const Vec<Dim>& x) { return 0.4 + slope.dot(x); }));
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const Vec<Dim> x = random_point<Dim>(random);
    EXPECT_NEAR(f(x), 0.4 + slope.dot(x), 1e-13);
    EXPECT_LT((f.of_leaf(space.locate(x), x).second - slope).norm(), 1e-11);
  }
}

TYPED_TEST(Splines, ReproduceQuadraticFunctionsInside) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(3);
  const SplineSpace<Dim> space(grid);
  Mat<Dim> a;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) a(i, j) = 1 + i - 0.5 * j;
  const auto q = [&](const Vec<Dim>& x) { return x.dot(a * x); };
  const Function<Dim> f(space, values<Dim>(grid, q));
  std::mt19937 random(6);
  for (int i = 0; i < 500; ++i) {
    const Vec<Dim> x = random_point<Dim>(random, 0.26, 0.74);  // at least two cells from the boundary
    EXPECT_NEAR(f(x), q(x), 1e-13);
  }
}

// Means over the corners never leave the range of the values, whatever these are.
TYPED_TEST(Splines, MeansStayWithinTheRangeOfTheValues) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid = random_grid<Dim>(1, 3, 0.4, 8);
  const SplineSpace<Dim> space(grid);
  std::mt19937 random(8);
  const auto jagged = values<Dim>(grid, [&](const Vec<Dim>&) { return random() % 2 ? 1.0 : 20.0; });
  const Function<Dim> means(space, jagged, 0), quasi(space, jagged);
  double least = 1e9, greatest = 0, least_of_quasi = 1e9;
  for (int i = 0; i < 3000; ++i) {
    const Vec<Dim> x = random_point<Dim>(random);
    least = std::min(least, means(x));
    greatest = std::max(greatest, means(x));
    least_of_quasi = std::min(least_of_quasi, quasi(x));
  }
  EXPECT_GE(least, 1 - 1e-12);
  EXPECT_LE(greatest, 20 + 1e-12);
  EXPECT_LT(least_of_quasi, 0) << "which is why roots are not quasi-interpolated";
}

// Halving the cells divides the error by eight, and that of multilinear interpolation by four.
TYPED_TEST(Splines, AreOfThirdOrder) {
  constexpr int Dim = TypeParam::value;
  const auto smooth = [](const Vec<Dim>& x) { return std::sin(5 * x.sum()) + std::cos(4 * x[0]); };
  const auto errors = [&](int level) {
    const Octree<Dim> grid(level);
    const SplineSpace<Dim> space(grid);
    const std::vector<double> nodal = values<Dim>(grid, smooth);
    const Function<Dim> f(space, nodal);
    std::mt19937 random(7);
    Vec<2> sum = Vec<2>::Zero();
    for (int i = 0; i < 2000; ++i) {
      const Vec<Dim> x = random_point<Dim>(random, 0.26, 0.74);
      sum += Vec<2>(std::abs(f(x) - smooth(x)), std::abs(evaluate(grid, nodal, x) - smooth(x)));
    }
    return Vec<2>(sum / 2000);
  };
  const Vec<2> coarse = errors(4), fine = errors(5);
  EXPECT_GT(std::log2(coarse[0] / fine[0]), 2.8);
  EXPECT_NEAR(std::log2(coarse[1] / fine[1]), 2, 0.15);
  EXPECT_LT(fine[0], 0.2 * fine[1]);
}

}  // namespace
}  // namespace shellmatch
