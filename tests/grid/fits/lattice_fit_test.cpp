#include "grid/fits/lattice_fit.h"

#include "grid/fits/local_fit.h"
#include "grid/fits/quadratic_fit.h"
#include "grid/fields/sample.h"

#include <gtest/gtest.h>

#include <optional>

namespace shellmatch {
namespace {

template <class D>
class LatticeFitTest : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(LatticeFitTest, Dims);

template <int Dim>
std::vector<double> some_field(const Octree<Dim>& grid) {
  return sample_nodes<Dim>(grid, [](const Vec<Dim>& x) { return std::sin(5 * x[0] * x[1]) + x.norm(); });
}

// The same by a search through all free nodes: whoever is not farther than the n-th nearest.
template <int Dim>
std::vector<Index> nearest_by_search(const Octree<Dim>& grid, Index node, std::size_t n) {
  const auto distance = [&](Index other) { return (grid.node_position(other) - grid.node_position(node)).norm(); };
  std::vector<Index> all(grid.free_nodes().begin(), grid.free_nodes().end());
  std::erase(all, node);
  std::ranges::sort(all, {}, distance);
  const double farthest = distance(all[n - 1]);
  std::erase_if(all, [&](Index other) { return distance(other) > farthest * (1 + 1e-12); });
  return all;
}

/// What the fit is by its definition.
template <int Dim>
std::optional<SymmetricComponents<Dim>> hessian_by_search(const Octree<Dim>& grid, const std::vector<double>& field,
                                                          Index node, const std::vector<Index>& nearest,
                                                          double exponent) {
  const auto difference = [&](Index other) -> Vec<Dim> { return grid.node_position(other) - grid.node_position(node); };
  const double radius = difference(nearest.back()).norm();
  QuadraticFit<Dim, 1> fit;
  fit.add(Vec<Dim>::Zero(), {0.0}, std::pow(difference(nearest.front()).norm() / radius, -exponent));
  for (const Index other : nearest) {
    const Vec<Dim> x = difference(other) / radius;
    fit.add(x, {field[other] - field[node]}, std::pow(x.norm(), -exponent));
  }
  if (!fit.factorise()) return std::nullopt;
  auto hessian = fit.hessian(0);
  for (double& h : hessian) h /= radius * radius;
  return hessian;
}

template <int Dim>
void expect_near(const SymmetricComponents<Dim>& a, const SymmetricComponents<Dim>& b) {
  for (std::size_t m = 0; m < a.size(); ++m) EXPECT_NEAR(a[m], b[m], 1e-9);
}

// Where the grid is uniform and where it is not.
TYPED_TEST(LatticeFitTest, NeighboursAndSecondDerivativesAreThoseOfASearch) {
  constexpr int Dim = TypeParam::value;
  CoefficientOptions options;
  options.neighbours = Dim == 2 ? 12 : 32;
  const auto n = static_cast<std::size_t>(options.neighbours);
  Octree<Dim> grid(Dim == 2 ? 5 : 3);
  grid.refine([&](Index leaf) { return grid.cell_centre(leaf)[0] + 0.3 * grid.cell_centre(leaf)[1] < 0.6; });
  const auto field = some_field(grid);
  for (const double exponent : {0.0, 2.0}) {
    options.fit_weight = exponent;
    const LatticeFit<Dim> lattice(grid, n, exponent);
    const auto fitted = fit_hessians<Dim>(grid, field, options, grid.free_nodes());
    int n_found = 0, n_searched = 0;
    for (std::size_t i = 0; i < fitted.size(); i += 7) {
      const Index node = grid.free_nodes()[i];
      auto expected = nearest_by_search(grid, node, n);
      const auto hessian = hessian_by_search<Dim>(grid, field, node, expected, exponent);
      if (!hessian) continue;  // the search goes on with more
      expect_near<Dim>(fitted[i], *hessian);
      std::vector<Index> found;
      const double side = lattice.find_neighbours(node, found);
      ++(side > 0 ? n_found : n_searched);
      if (side == 0) continue;
      expect_near<Dim>(lattice.hessian(field, node, side, found), *hessian);
      std::ranges::sort(found);
      std::ranges::sort(expected);
      EXPECT_EQ(found, expected);
    }
    EXPECT_GT(n_found, 20);
    EXPECT_GT(n_searched, 20);  // at the boundary of the domain and next to other sizes
  }
}

// More than a lattice's ball of two cells holds is for the search.
TYPED_TEST(LatticeFitTest, LeavesWideNeighbourhoodsAlone) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(4);
  const Index middle = grid.find_node([] {
    typename Octree<Dim>::Coord c;
    c.fill(1 << (Octree<Dim>::max_level - 1));
    return c;
  }());
  std::vector<Index> found;
  EXPECT_GT(LatticeFit<Dim>(grid, Dim == 2 ? 12 : 32, 0).find_neighbours(middle, found), 0);
  EXPECT_EQ(LatticeFit<Dim>(grid, Dim == 2 ? 13 : 33, 0).find_neighbours(middle, found), 0);
  EXPECT_EQ(LatticeFit<Dim>(grid, 1000, 0).find_neighbours(middle, found), 0);
}

}  // namespace
}  // namespace shellmatch
