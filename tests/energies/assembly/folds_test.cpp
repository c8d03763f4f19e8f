#include "energies/assembly/folds.h"

#include "energies/terms/fold_barrier.h"
#include "grid/fields/interpolation.h"
#include "grid/octree/prolongation.h"
#include "tests/energies/matching_problem.h"
#include "tests/energies/densities/random_matrices.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shellmatch {
namespace {

using namespace test;

// One cell, the whole domain, with its corners moved at random by up to `amount`.
template <int Dim>
struct RandomCell {
  Element<Dim> element;
  std::vector<Vec<Dim>> phi;
  RandomCell(std::mt19937& random, double amount, double side = 1) : element{{}, side}, phi(n_corners<Dim>) {
    for (int c = 0; c < n_corners<Dim>; ++c) {
      element.nodes[c] = c;
      for (int k = 0; k < Dim; ++k) phi[c][k] = side * ((c >> k) & 1);
      phi[c] += side * random_point<Dim>(random, -amount, amount);
    }
  }
  double determinant(const Vec<Dim>& xi) const {
    const auto gradients = shape_gradients<Dim>(xi);
    Mat<Dim> d = Mat<Dim>::Zero();
    for (int c = 0; c < n_corners<Dim>; ++c) d += phi[c] * gradients[c].transpose() / element.side;
    return d.determinant();
  }
};

template <class T>
struct Folds : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Folds, Dimensions);

TYPED_TEST(Folds, BoundsAreExactForAffineMaps) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(1);
  const Octree<Dim> grid = hanging_grid<Dim>(0.3);
  const Unknowns<Dim> unknowns(grid, BoundaryCondition::neumann);
  for (int i = 0; i < 10; ++i) {
    const Mat<Dim> a = random_matrix<Dim>(random);
    const auto phi = at_nodes<Dim>(grid, [&](const Vec<Dim>& x) { return Vec<Dim>(a * x); });
    for (const auto& [smallest, bound] : determinant_bounds<Dim>(unknowns.elements(), phi)) {
      ASSERT_NEAR(smallest, a.determinant(), 1e-12);
      ASSERT_NEAR(bound, a.determinant(), 1e-12);
    }
    const FoldReport report = find_folds<Dim>(unknowns.elements(), phi);
    const bool folds = a.determinant() < 0;
    EXPECT_NEAR(report.min_determinant, a.determinant(), 1e-12);
    EXPECT_EQ(report.n_folded_cells, folds ? static_cast<Index>(unknowns.elements().size()) : 0);
    EXPECT_NEAR(report.folded_volume, folds ? 1 : 0, 1e-12);
  }
}

TYPED_TEST(Folds, CoefficientsAreThoseOfTheDeterminant) {
  constexpr int Dim = TypeParam::value, n = n_bernstein<Dim>;
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const RandomCell<Dim> cell(random, 1);
    std::vector<double> dofs;
    for (const auto& y : cell.phi) dofs.insert(dofs.end(), y.begin(), y.end());
    const auto b = bernstein_determinant<Dim>(dofs.data());
    for (int j = 0; j < 20; ++j) {
      const Vec<Dim> xi = random_point<Dim>(random);
      double value = 0;
      for (int m = 0; m < n_bernstein_total<Dim>; ++m) {
        double basis = 1;
        for (int k = 0, rest = m; k < Dim; ++k, rest /= n) {
          const double t = xi[k], s = 1 - t;
          const double functions[] = {n == 2 ? s : s * s, n == 2 ? t : 2 * s * t, t * t};
          basis *= functions[rest % n];
        }
        value += b[m] * basis;
      }
      EXPECT_NEAR(value, cell.determinant(xi), 1e-12);
    }
  }
}

TYPED_TEST(Folds, BoundIsNeverAboveTheDeterminant) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(3);
  int n_certified = 0;
  for (int i = 0; i < 200; ++i) {
    const RandomCell<Dim> cell(random, i % 2 ? 0.15 : 1, 0.25);
    const auto [at_corners, bound] = determinant_bounds<Dim>({&cell.element, 1}, cell.phi)[0];
    EXPECT_LE(bound, at_corners);
    double sampled = at_corners;
    for (int j = 0; j < 200; ++j) sampled = std::min(sampled, cell.determinant(random_point<Dim>(random)));
    EXPECT_LE(bound, sampled + 1e-13);
    // A certificate that is worth its name: thousands of points, all positive.
    if (bound > 0) {
      EXPECT_GT(sampled, 0);
      ++n_certified;
    }
  }
  EXPECT_GT(n_certified, 50);
}

TYPED_TEST(Folds, AnInvertedCellIsFound) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid = hanging_grid<Dim>(0.3);
  const Unknowns<Dim> unknowns(grid, BoundaryCondition::neumann);
  auto phi = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
  EXPECT_EQ(find_folds<Dim>(unknowns.elements(), phi).n_uncertified_cells, 0);
  // A node in the middle, pushed beyond its upper neighbours: the cells above it turn over.
  Index middle = no_index;
  for (const Index node : grid.free_nodes())
    if ((grid.node_position(node) - Vec<Dim>::Constant(0.5)).norm() < 1e-9) middle = node;
  ASSERT_NE(middle, no_index);
  phi[middle][0] += 0.5;
  const FoldReport report = find_folds<Dim>(unknowns.elements(), phi);
  EXPECT_LT(report.min_determinant, 0);
  EXPECT_LE(report.lower_bound, report.min_determinant);
  EXPECT_GE(report.n_folded_cells, n_corners<Dim> / 2);
  EXPECT_GE(report.n_uncertified_cells, report.n_folded_cells);
  EXPECT_GT(report.folded_volume, 0);
  EXPECT_LT(report.folded_volume, 0.5);
}

TYPED_TEST(Folds, SubdivisionNeverLowersTheBound) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(4);
  for (int i = 0; i < 50; ++i) {
    Octree<Dim> grid(0);
    auto phi = RandomCell<Dim>(random, 0.6).phi;
    // Corner c of the only cell is its node number nodes[c].
    std::vector<Vec<Dim>> nodal(phi.size());
    for (int c = 0; c < n_corners<Dim>; ++c) nodal[grid.cell(0).nodes[c]] = phi[c];
    double bound = -1e300;
    for (int level = 0; level < 3; ++level) {
      const Unknowns<Dim> unknowns(grid, BoundaryCondition::neumann);
      const FoldReport report = find_folds<Dim>(unknowns.elements(), nodal);
      EXPECT_GE(report.lower_bound, bound - 1e-12);
      EXPECT_LE(report.lower_bound, report.min_determinant);
      bound = report.lower_bound;
      const Index n_old = grid.n_nodes();
      grid.refine([](Index) { return true; });
      prolongate(grid, n_old, nodal);
    }
  }
}

TYPED_TEST(Folds, WhatIsNoNumberIsNotCertified) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid(3);
  const Unknowns<Dim> unknowns(grid, BoundaryCondition::neumann);
  const auto identity = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
  ASSERT_EQ(find_folds<Dim>(unknowns.elements(), identity).n_uncertified_cells, 0);
  const auto& nodes = unknowns.elements()[5].nodes;
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (int corner = 0; corner < n_corners<Dim>; ++corner) {
      auto phi = identity;
      phi[nodes[corner]][Dim - 1] = wrong;
      const FoldReport report = find_folds<Dim>(unknowns.elements(), phi);
      EXPECT_GE(report.n_uncertified_cells, 1) << wrong << " at corner " << corner;
      EXPECT_TRUE(std::isnan(determinant_bounds<Dim>(unknowns.elements(), phi)[5].bound))
          << wrong << " at corner " << corner;
    }
}

}  // namespace
}  // namespace shellmatch
