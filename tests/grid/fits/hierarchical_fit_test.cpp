#include "grid/fits/hierarchical_fit.h"

#include "grid/fields/sample.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

template <class D>
class HierarchicalFitTest : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(HierarchicalFitTest, Dims);

template <int Dim>
double cubic(const Vec<Dim>& x) {
  return 3 + x[0] * x[1] - 2 * x[0] * x[0] + x[0] * x[0] * x[0] - 4 * x[1] * x[1] * x[Dim - 1];
}

template <int Dim>
Mat<Dim> second_derivative(const Vec<Dim>& x) {
  Mat<Dim> h = Mat<Dim>::Zero();
  h(0, 0) = -4 + 6 * x[0];
  h(0, 1) = h(1, 0) = 1;
  // -4 y^2 z, which is -4 y^3 in the plane
  h(1, 1) = Dim == 2 ? -24 * x[1] : -8 * x[Dim - 1];
  if (Dim == 3) h(1, Dim - 1) = h(Dim - 1, 1) = -8 * x[1];
  return h;
}

/// Refines around a sphere in the middle, calling `visit` with every grid.
template <int Dim, class Visit>
void refine_step_by_step(Octree<Dim>& grid, int finest, Visit&& visit) {
  visit();
  while (grid.finest_level() < finest) {
    const double side = grid.finest_side();
    grid.refine([&](Index leaf) {
      const double distance = (grid.cell_centre(leaf) - Vec<Dim>::Constant(0.5)).norm() - 0.15;
      return grid.cell(leaf).level == grid.finest_level() && std::abs(distance) < 1.5 * side;
    });
    visit();
  }
}

/// Largest error in the middle, away from the domain's boundary.
template <int Dim, class Hessian>
double error_in_the_middle(const Octree<Dim>& grid, Hessian&& hessian) {
  double error = 0;
  for (const Index node : grid.free_nodes()) {
    const Vec<Dim> x = grid.node_position(node);
    if ((x - Vec<Dim>::Constant(0.5)).cwiseAbs().maxCoeff() > 0.24) continue;
    error = std::max(error, (unpack_symmetric<Dim>(hessian(node)) - second_derivative<Dim>(x)).norm());
  }
  return error;
}

// Lattices are symmetric, so that cubics have the right second derivatives, and means of linear functions are
// exact. Neighbourhoods that are searched for lean to the finer side.
TYPED_TEST(HierarchicalFitTest, ExactForCubicsWhereSizesChangeToo) {
  constexpr int Dim = TypeParam::value;
  Octree<Dim> grid(4);
  HierarchicalFit<Dim> fit;
  std::vector<double> field;
  refine_step_by_step<Dim>(grid, Dim == 2 ? 7 : 6, [&] {
    field = sample_nodes<Dim>(grid, cubic<Dim>);
    fit.update(grid, field, {});
  });
  ASSERT_EQ(fit.size(), static_cast<std::size_t>(grid.n_nodes()));
  EXPECT_LT(error_in_the_middle<Dim>(grid, [&](Index node) { return fit[node]; }), 1e-8);
  const auto searched = fit_hessians<Dim>(grid, field, {}, grid.free_nodes());
  EXPECT_GT(error_in_the_middle<Dim>(grid, [&](Index node) { return searched[grid.free_index(node)]; }), 1e-2);
}

// Its first grid, and neighbourhoods that are wider than a lattice's ball, are those of the search everywhere.
TYPED_TEST(HierarchicalFitTest, IsTheSearchedFitOtherwise) {
  constexpr int Dim = TypeParam::value;
  const auto field = [](const Octree<Dim>& grid) {
    return sample_nodes<Dim>(grid, [](const Vec<Dim>& x) { return std::sin(4 * x[0] * x[1]); });
  };
  for (const int neighbours : {0, 40}) {
    CoefficientOptions options;
    options.neighbours = neighbours;
    Octree<Dim> grid(3);
    HierarchicalFit<Dim> fit;
    refine_step_by_step<Dim>(grid, neighbours == 0 ? 3 : 5, [&] { fit.update(grid, field(grid), options); });
    const auto expected = fit_hessians<Dim>(grid, field(grid), options, grid.free_nodes());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(fit[grid.free_nodes()[i]], expected[i]) << neighbours;
  }
}

}  // namespace
}  // namespace shellmatch
