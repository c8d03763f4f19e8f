// The model's matrix by unknowns against what it stands for: C^T K C with the elements' matrices K, one by
// one.

#include "energies/sparse/node_matrix.h"

#include <gtest/gtest.h>

#include <random>

#include "base/parallel.h"
#include "tests/energies/matching_problem.h"

namespace shellmatch::test {
namespace {

template <int Dim>
struct RandomMatrices {
  explicit RandomMatrices(const Unknowns<Dim>& unknowns) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> u(-1, 1);
    matrices.resize(unknowns.elements().size());
    for (std::size_t e = 0; e < matrices.size(); ++e)
      for (int i = 0; i < ElementMatrices<Dim>::n_dofs; ++i)
        for (int j = i; j < ElementMatrices<Dim>::n_dofs; ++j) matrices.set(e, i, j, u(random));
  }
  ElementMatrices<Dim> matrices;
};

// Patch by cells, as the model does it, and once more: what was there before does not count.
template <int Dim>
void assemble(NodeMatrix<Dim>& sum, const Unknowns<Dim>& unknowns, const ElementMatrices<Dim>& all) {
  const CellBlocks<Dim> cell_blocks(unknowns);
  for (int time = 0; time < 2; ++time)
    cell_blocks.for_each([&](const Chunk& cells) {
      ElementMatrices<Dim> of_block;
      of_block.resize(cells.end - cells.begin);
      for (std::size_t e = cells.begin; e < cells.end; ++e) of_block[e - cells.begin] = all[e];
      sum.add(cell_blocks, cells, of_block);
    });
}

std::vector<double> random_vector(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> x(n);
  for (double& v : x) v = normal(random);
  return x;
}

// Element by element: the unknowns go out to the corners, the products come back.
template <int Dim, class Entry>
std::vector<double> product(const Octree<Dim>& grid, const Unknowns<Dim>& unknowns, std::span<const double> x,
                            Entry&& entry) {
  std::vector<Vec<Dim>> nodal(static_cast<std::size_t>(grid.n_nodes()), Vec<Dim>::Zero());
  unknowns.expand(x, nodal);
  constexpr int n = ElementMatrices<Dim>::n_dofs;
  std::vector<double> products(unknowns.elements().size() * n, 0.0);
  for (std::size_t e = 0; e < unknowns.elements().size(); ++e)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        products[e * n + static_cast<std::size_t>(i)] +=
            entry(e, i, j) * nodal[unknowns.elements()[e].nodes[j / Dim]][j % Dim];
  return sum_elements(unknowns, std::span<const double>(products));
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], tolerance) << i;
}

template <int Dim>
void check_products(BoundaryCondition boundary) {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const Unknowns<Dim> unknowns(grid, boundary);
  const RandomMatrices<Dim> k(unknowns);
  NodeMatrix<Dim> sum(unknowns);
  assemble(sum, unknowns, k.matrices);
  const auto x = random_vector(unknowns.size(), 1);
  std::vector<double> y(x.size());
  sum.multiply(x, y);
  const auto of_elements = [&](std::size_t e, int i, int j) {
    return static_cast<double>(k.matrices[e][ElementMatrices<Dim>::entry(std::min(i, j), std::max(i, j))]);
  };
  expect_near(y, product<Dim>(grid, unknowns, x, of_elements), 2e-5);

  // Element 3 stiffened by a matrix of its own.
  std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>> stiff;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int d = 0; d < n_corners<Dim>; ++d) stiff[c][d] = 1.0 + c * d;
  for (std::size_t e = 0; e < unknowns.elements().size(); e += 3) sum.add_isotropic(e, 0.25, stiff);
  sum.multiply(x, y);
  expect_near(y,
              product<Dim>(grid, unknowns, x,
                           [&](std::size_t e, int i, int j) {
                             return of_elements(e, i, j) +
                                    (e % 3 == 0 && i % Dim == j % Dim ? 0.25 * stiff[i / Dim][j / Dim] : 0.0);
                           }),
              2e-4);
}
TEST(NodeMatrix, IsTheSumOfTheElementsMatrices) {
  check_products<2>(BoundaryCondition::neumann);
  check_products<3>(BoundaryCondition::neumann);
}
TEST(NodeMatrix, LeavesOutFixedNodes) {
  check_products<2>(BoundaryCondition::dirichlet);
  check_products<3>(BoundaryCondition::dirichlet);
}

// A hanging node's block reaches its parents' diagonals with the product of both weights.
TEST(NodeMatrix, DiagonalBlocksAreThoseOfProducts) {
  const Octree<3> grid = hanging_grid<3>(0.28);
  const Unknowns<3> unknowns(grid, BoundaryCondition::neumann);
  const RandomMatrices<3> k(unknowns);
  NodeMatrix<3> sum(unknowns);
  assemble(sum, unknowns, k.matrices);
  std::vector<double> x(unknowns.size(), 0.0), y(x.size());
  for (std::size_t i = 0; i < unknowns.nodes().size(); i += 7)
    for (std::size_t l = 0; l < 3; ++l) {
      x[3 * i + l] = 1;
      sum.multiply(x, y);
      for (std::size_t m = 0; m < 3; ++m)
        EXPECT_EQ(y[3 * i + m], sum.diagonal(i)(static_cast<int>(m), static_cast<int>(l)));
      x[3 * i + l] = 0;
    }
}

TEST(NodeMatrix, GivesTheSameBitsWhateverTheThreads) {
  const Octree<3> grid = hanging_grid<3>(0.28);
  const Unknowns<3> unknowns(grid, BoundaryCondition::neumann);
  const RandomMatrices<3> k(unknowns);
  const auto x = random_vector(unknowns.size(), 2);
  std::vector<std::vector<double>> results;
  for (const int n : {1, 3}) {
    set_n_threads(n);
    NodeMatrix<3> sum(unknowns);
    assemble(sum, unknowns, k.matrices);
    results.emplace_back(x.size());
    sum.multiply(x, results.back());
  }
  set_n_threads(0);
  EXPECT_EQ(results[0], results[1]);
}

}  // namespace
}  // namespace shellmatch::test
