#include "grid/fields/projection.h"

#include "base/parallel.h"
#include "grid/fields/sample.h"
#include "tests/grid/exact_shapes.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using test::random_grid;

template <class D>
class ProjectionTest : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ProjectionTest, Dims);

TYPED_TEST(ProjectionTest, ExactForLinearFunctions) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(2, 3, 0.2, 1);
  Vec<Dim> slope;
  for (int k = 0; k < Dim; ++k) slope[k] = 1.0 - 0.7 * k;
  const auto d = sample_nodes<Dim>(grid, [&](const Vec<Dim>& x) { return 3 - slope.dot(x); });
  for (const auto mass : {MassKind::consistent, MassKind::lumped}) {
    for (const auto& g : project_gradient<Dim>(grid, d, mass)) ASSERT_LE((g + slope).norm(), 1e-12);
    for (const auto& n : nodal_normals<Dim>(grid, d, mass)) ASSERT_LE((n + slope.normalized()).norm(), 1e-12);
  }
}

template <int Dim>
Vec<Dim> axes() {
  Vec<Dim> a = Vec<Dim>::Constant(0.32);
  a[0] = 0.25;
  return a;
}

// Root mean square error of the normals at the free nodes within `width` of an ellipsoid.
template <int Dim>
double normal_error(const Octree<Dim>& grid, MassKind mass, double width) {
  const auto shape = test::ellipsoid<Dim>(axes<Dim>());
  const auto d = sample_nodes<Dim>(grid, shape.distance);
  const auto normals = nodal_normals<Dim>(grid, d, mass);
  double sum = 0;
  int count = 0;
  for (const Index n : grid.free_nodes()) {
    if (std::abs(d[n]) > width) continue;
    EXPECT_NEAR(normals[n].norm(), 1, 1e-14);
    sum += (normals[n] - shape.normal(grid.node_position(n))).squaredNorm();
    ++count;
  }
  return std::sqrt(sum / count);
}

TYPED_TEST(ProjectionTest, SecondOrderOnUniformGrids) {
  constexpr int Dim = TypeParam::value;
  const int l = Dim == 2 ? 6 : 4;
  for (const auto mass : {MassKind::consistent, MassKind::lumped}) {
    const double order =
        std::log2(normal_error(Octree<Dim>(l), mass, 0.05) / normal_error(Octree<Dim>(l + 1), mass, 0.05));
    EXPECT_GT(order, 1.8);
    if (mass == MassKind::lumped) {
      EXPECT_LT(order, 2.3);  // the consistent mass matrix does better on uniform grids
    }
  }
}

// The band is two cells of the finest level wide on either side, as it is for the energies: all of it is near
// changes of the level.
TYPED_TEST(ProjectionTest, FirstOrderWhereTheLevelChanges) {
  constexpr int Dim = TypeParam::value;
  const int l = Dim == 2 ? 7 : 5;
  const auto shape = test::ellipsoid<Dim>(axes<Dim>());
  const auto coarse = test::shape_grid<Dim>(3, l, shape.distance),
             fine = test::shape_grid<Dim>(3, l + 1, shape.distance);
  std::array<double, 2> errors;
  for (const auto mass : {MassKind::consistent, MassKind::lumped}) {
    const double error = normal_error(fine, mass, 2 * fine.finest_side());
    EXPECT_GT(std::log2(normal_error(coarse, mass, 2 * coarse.finest_side()) / error), 0.8);
    errors[mass == MassKind::lumped] = error;
  }
  EXPECT_LT(errors[1], errors[0]) << "here the lumped mass matrix is no worse";
}

TYPED_TEST(ProjectionTest, NoNormalWhereTheGradientVanishes) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(3);
  for (const auto& n : nodal_normals<Dim>(grid, std::vector<double>(grid.n_nodes(), 0.2), MassKind::lumped))
    ASSERT_EQ(n, Vec<Dim>(Vec<Dim>::Zero()));
}

TYPED_TEST(ProjectionTest, SameBitsWithOneAndTwoThreads) {
  constexpr int Dim = TypeParam::value;
  const auto grid = random_grid<Dim>(Dim == 2 ? 5 : 3, 2, 0.3, 5);
  const auto d = sample_nodes<Dim>(grid, [](const Vec<Dim>& x) { return std::sin(3 * x[0]) * x[1]; });
  set_n_threads(1);
  const auto one = project_gradient<Dim>(grid, d, MassKind::consistent);
  set_n_threads(2);
  EXPECT_EQ(one, project_gradient<Dim>(grid, d, MassKind::consistent));
}

}  // namespace
}  // namespace shellmatch
