#include "grid/octree/surface_cells.h"

#include "grid/fields/sample.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

// Does the sphere meet the closed cube? Exactly if the cube's nearest point to the centre lies in the ball
// and its farthest does not lie in the open ball.
template <int Dim>
bool sphere_meets(const Vec<Dim>& low, double side, const Vec<Dim>& centre, double radius) {
  double nearest = 0, farthest = 0;
  for (int k = 0; k < Dim; ++k) {
    const double a = low[k] - centre[k], b = a + side;
    nearest += std::pow(std::max({a, -b, 0.0}), 2);
    farthest += std::pow(std::max(std::abs(a), std::abs(b)), 2);
  }
  return nearest <= radius * radius && farthest >= radius * radius;
}

template <int Dim>
void check_sphere(const Octree<Dim>& grid, double radius, const Vec<Dim>& centre) {
  const std::function<double(const Vec<Dim>&)> d = [&](const Vec<Dim>& x) { return (x - centre).norm() - radius; };
  const auto nodal = sample_nodes<Dim>(grid, d);
  int n_met = 0, n_too_many = 0, n_by_sign = 0;
  for (const Index leaf : grid.leaves()) {
    const bool expected = sphere_meets<Dim>(grid.cell_corner(leaf), grid.cell(leaf).side(), centre, radius);
    const bool found = meets_surface<Dim>(grid, nodal, d, leaf);
    if (expected) {
      ASSERT_TRUE(found) << "leaf " << leaf;
      ++n_met;
    }
    n_too_many += found && !expected;
    n_by_sign += changes_sign<Dim>(grid, nodal, leaf);
  }
  EXPECT_GT(n_met, 0);
  EXPECT_LE(n_too_many, 0.05 * n_met + 1) << "beside " << n_met;
  EXPECT_LE(n_by_sign, n_met);
}

TEST(Elements, AreFoundExactlyWhereTheSurfaceMeetsThem) {
  check_sphere<2>(Octree<2>(5), 0.31, {0.52, 0.47});
  check_sphere<3>(Octree<3>(4), 0.31, {0.52, 0.47, 0.5});
  check_sphere<3>(test::random_grid<3>(2, 2, 0.3, 1), 0.31, {0.52, 0.47, 0.5});
}

// Corners see nothing of a ball within a cell, and no sign change on a surface that pokes through a face.
TEST(Elements, SmallPartsAreNotMissed) {
  check_sphere<2>(Octree<2>(2), 0.02, {0.6, 0.4});
  check_sphere<3>(Octree<3>(2), 0.13, {0.37, 0.38, 0.375});
}

TEST(Elements, ChangeOfSignIncludesZero) {
  const Octree<2> grid(1);
  std::vector<double> nodal(grid.n_nodes(), 1.0);
  const Index leaf = grid.leaves()[0];
  EXPECT_FALSE(changes_sign<2>(grid, nodal, leaf));
  nodal[grid.cell(leaf).nodes[0]] = 0;
  EXPECT_TRUE(changes_sign<2>(grid, nodal, leaf));
  nodal.assign(grid.n_nodes(), -1.0);
  EXPECT_FALSE(changes_sign<2>(grid, nodal, leaf));
}

}  // namespace
}  // namespace shellmatch
