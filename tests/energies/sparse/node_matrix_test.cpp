// The matrix by unknowns against its definition, the sum of C^T K C over the elements.

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
    for (std::size_t e = 0; e < matrices.size(); ++e) {
      matrices.set(e, {});
      for (int i = 0; i < ElementMatrices<Dim>::n_dofs; ++i)
        for (int j = i; j < ElementMatrices<Dim>::n_dofs; ++j) matrices.add(e, i, j, u(random));
    }
  }
  ElementMatrices<Dim> matrices;
};

// Assembled block by block as in EnergyHessian, and a second time: the sum replaces the previous matrix.
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

// The product element by element: C x at the corners, then C^T times the products with the element matrices.
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

  // Every third element gets an additional isotropic matrix.
  std::array<std::array<double, n_corners<Dim>>, n_corners<Dim>> stiff;
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int d = 0; d < n_corners<Dim>; ++d) stiff[c][d] = 1.0 + c * d;
  const auto of_corners = [&](int c, int d) { return stiff[c][d]; };
  for (std::size_t e = 0; e < unknowns.elements().size(); e += 3)
    sum.add_to_element(e, of_corners, 0.25 * Mat<Dim>::Identity());
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

// Blocks of hanging nodes are added to the diagonal blocks of their parents with the product of both weights.
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

// On a uniform grid with m nodes per axis, 3 m - 2 ordered pairs of positions along an axis are neighbours or equal.
TEST(NodeMatrix, StoresABlockForEachPairOfNeighbours) {
  const Octree<3> grid(3);
  const Unknowns<3> unknowns(grid, BoundaryCondition::neumann);
  const NodeMatrix<3> matrix(unknowns);
  constexpr std::size_t m = 9, pairs = 3 * m - 2;
  EXPECT_EQ(matrix.n_blocks(), (pairs * pairs * pairs + m * m * m) / 2);
  EXPECT_EQ(matrix.n_element_blocks(), 512u * 36);
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
