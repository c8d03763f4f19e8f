#include "energies/elements/unknowns.h"

#include "grid/octree/constraints.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace shellmatch {
namespace {

using namespace test;

std::vector<double> random_numbers(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> x(n);
  for (double& v : x) v = uniform(random);
  return x;
}

// <expand(x) at the elements' corners, g> = <x, sum of g>, the rest of the field being zero.
template <int Dim>
void check_adjoint(BoundaryCondition boundary) {
  const Octree<Dim> grid = hanging_grid<Dim>(0.3);
  ASSERT_FALSE(grid.hanging_nodes().empty());
  const Unknowns<Dim> unknowns(grid, boundary);
  const auto elements = unknowns.elements();
  const auto x = random_numbers(unknowns.size(), 1);
  const auto g = random_numbers(elements.size() * n_corners<Dim> * Dim, 2);
  std::vector<Vec<Dim>> nodal(grid.n_nodes(), Vec<Dim>::Zero());
  unknowns.expand(x, nodal);
  double at_elements = 0;
  for (std::size_t e = 0, i = 0; e < elements.size(); ++e)
    for (const Index node : elements[e].nodes)
      for (int k = 0; k < Dim; ++k) at_elements += nodal[node][k] * g[i++];
  const std::vector<double> sums = sum_elements(unknowns, g);
  EXPECT_NEAR(at_elements, std::inner_product(x.begin(), x.end(), sums.begin(), 0.0), 1e-11);
}

TEST(Unknowns, SumOfElementsIsTheTransposeOfExpand) {
  for (const auto boundary : {BoundaryCondition::neumann, BoundaryCondition::dirichlet}) {
    check_adjoint<2>(boundary);
    check_adjoint<3>(boundary);
  }
}

template <int Dim>
void check_fields(BoundaryCondition boundary) {
  const Octree<Dim> grid = hanging_grid<Dim>(0.45);  // refined at the boundary too
  const Unknowns<Dim> unknowns(grid, boundary);
  auto nodal = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
  const auto before = nodal;
  const auto x = random_numbers(unknowns.size(), 3);
  unknowns.expand(x, nodal);
  auto again = nodal;
  distribute(grid, again);
  std::size_t n_fixed = 0;
  for (Index node = 0; node < grid.n_nodes(); ++node) {
    EXPECT_EQ(nodal[node], again[node]) << "hanging nodes lie between their parents";
    if (boundary == BoundaryCondition::neumann || !grid.is_boundary_node(node)) continue;
    EXPECT_EQ(nodal[node], before[node]) << "the boundary must not move";
    n_fixed += grid.free_index(node) != no_index;
  }
  EXPECT_EQ(n_fixed > 0, boundary == BoundaryCondition::dirichlet);
  EXPECT_EQ(unknowns.nodes().size() + n_fixed, grid.free_nodes().size());
  std::vector<double> back(unknowns.size());
  unknowns.restrict_to(nodal, back);
  EXPECT_EQ(back, x);
}

TEST(Unknowns, AreTheFreeNodesAwayFromAFixedBoundary) {
  for (const auto boundary : {BoundaryCondition::neumann, BoundaryCondition::dirichlet}) {
    check_fields<2>(boundary);
    check_fields<3>(boundary);
  }
}

template <int Dim>
void check_order() {
  const Octree<Dim> grid = hanging_grid<Dim>(0.45);
  const Unknowns<Dim> unknowns(grid, BoundaryCondition::dirichlet);
  Index n_met = 0;
  for (const Element<Dim>& element : unknowns.elements())
    for (const Index node : element.nodes)
      for (const auto& carrier : unknowns.carriers_of(node)) {
        EXPECT_LE(carrier.unknown, n_met) << "one that no element has met has a smaller number";
        n_met = std::max(n_met, carrier.unknown + 1);
      }
  EXPECT_EQ(static_cast<std::size_t>(n_met), unknowns.nodes().size());
}

TEST(Unknowns, AreNumberedAsTheElementsMeetThem) {
  check_order<2>();
  check_order<3>();
}

// The table is made of functions that sum to 1 and reproduce the point's own place.
TEST(ShapeTable, ReproducesLinearFunctions) {
  for (int order = 1; order <= 5; ++order)
    for (const auto& q : ShapeTable<3>(order).points) {
      Vec<3> place = Vec<3>::Zero();
      Mat<3> slope = Mat<3>::Zero();
      for (int c = 0; c < 8; ++c) {
        const Vec<3> corner(c & 1, (c >> 1) & 1, (c >> 2) & 1);
        place += q.n[c] * corner;
        slope += corner * Vec<3>(q.dn[c][0], q.dn[c][1], q.dn[c][2]).transpose();
      }
      EXPECT_LT((place - q.xi).norm(), 1e-15);
      EXPECT_LT((slope - Mat<3>::Identity()).norm(), 1e-15);
    }
}

}  // namespace
}  // namespace shellmatch
