#include "energies/elements/element_unknowns.h"

#include "grid/octree/constraints.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <set>
#include <tuple>

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

// <expand(x) at the elements' corners, g> = <x, C^T g>, where the field is zero at fixed nodes.
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
      for (const ConstraintEntry& entry : unknowns.constraint_entries(node)) {
        EXPECT_LE(entry.unknown, n_met) << "an unknown that elements meet later has a smaller number";
        n_met = std::max(n_met, entry.unknown + 1);
      }
  EXPECT_EQ(static_cast<std::size_t>(n_met), unknowns.nodes().size());
}

TEST(Unknowns, AreNumberedAsTheElementsMeetThem) {
  check_order<2>();
  check_order<3>();
}

// Where fixed nodes have value 0, a nodal field is C x.
template <int Dim>
void check_constraint_entries(BoundaryCondition boundary) {
  const Octree<Dim> grid = hanging_grid<Dim>(0.45);
  const Unknowns<Dim> unknowns(grid, boundary);
  const auto x = random_numbers(unknowns.size(), 4);
  std::vector<Vec<Dim>> nodal(grid.n_nodes(), Vec<Dim>::Zero());
  unknowns.expand(x, nodal);
  for (Index node = 0; node < grid.n_nodes(); ++node)
    for (int k = 0; k < Dim; ++k) {
      double sum = 0;
      for (const ConstraintEntry& entry : unknowns.constraint_entries(node))
        sum += entry.weight * x[entry.unknown * Dim + k];
      EXPECT_NEAR(nodal[node][k], sum, 1e-15);
    }
}

TEST(Unknowns, ConstraintEntriesAreTheMatrixOfExpand) {
  for (const auto boundary : {BoundaryCondition::neumann, BoundaryCondition::dirichlet}) {
    check_constraint_entries<2>(boundary);
    check_constraint_entries<3>(boundary);
  }
}

// By corners or by unknowns, the entries of an element are the same.
template <int Dim>
void check_element_unknowns() {
  const Octree<Dim> grid = hanging_grid<Dim>(0.45);
  const Unknowns<Dim> unknowns(grid, BoundaryCondition::dirichlet);
  for (std::size_t e = 0; e < unknowns.elements().size(); ++e) {
    using Entry = std::tuple<int, Index, float>;  // corner, unknown, weight
    std::multiset<Entry> expected, found;
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (const ConstraintEntry& entry : unknowns.constraint_entries(unknowns.elements()[e].nodes[c]))
        expected.emplace(c, entry.unknown, entry.weight);
    std::set<Index> distinct;
    const auto of_element = element_unknowns(unknowns, e);
    for (int i = 0; i < of_element.size(); ++i) {
      EXPECT_TRUE(distinct.insert(of_element[i]).second);
      for (const auto& [corner, weight] : of_element.corners_of(i)) found.emplace(corner, of_element[i], weight);
    }
    EXPECT_EQ(found, expected) << e;
  }
}

TEST(ElementUnknowns, AreTheConstraintEntriesByUnknown) {
  check_element_unknowns<2>();
  check_element_unknowns<3>();
}

}  // namespace
}  // namespace shellmatch
