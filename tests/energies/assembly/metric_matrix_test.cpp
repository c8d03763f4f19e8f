// The matrices of the metrics on constants and linear functions, with hanging nodes.
#include "energies/assembly/metric_matrix.h"
#include "energies/terms/term_names.h"

#include "grid/fields/mass.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

namespace shellmatch::test {
namespace {

using Vector = Eigen::VectorXd;

template <int Dim>
Vector at_unknowns(const Octree<Dim>& grid, const Unknowns<Dim>& unknowns, const Vec<Dim>& slope) {
  Vector v(static_cast<Eigen::Index>(unknowns.nodes().size()));
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = grid.node_position(unknowns.nodes()[i]).dot(slope);
  return v;
}

template <class T>
class MetricMatrix : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(MetricMatrix, Dimensions);

TYPED_TEST(MetricMatrix, IntegratesGradientsOfLinearFunctionsExactly) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid = hanging_grid<Dim>(0.3);
  ASSERT_FALSE(grid.hanging_nodes().empty());
  const Problem<Dim> p(grid, linear_fields(grid), linear_fields(grid));
  const auto matrix = [&](const MetricWeights& w) { return metric_matrix<Dim>(grid, p.unknowns, p.energy, w); };
  Vec<Dim> a, b;
  for (int k = 0; k < Dim; ++k) {
    a[k] = 1 + k;
    b[k] = 2 - 0.7 * k;
  }
  const Vector u = at_unknowns<Dim>(grid, p.unknowns, a), v = at_unknowns<Dim>(grid, p.unknowns, b);
  const Vector one = Vector::Ones(u.size());

  const auto stiffness = matrix({.mass = 0, .stiffness = 3});
  EXPECT_NEAR(u.dot(stiffness * v), 3 * a.dot(b), 1e-12);
  EXPECT_NEAR((stiffness * one).norm(), 0, 1e-12);
  EXPECT_NEAR((stiffness - Eigen::SparseMatrix<double>(stiffness.transpose())).norm(), 0, 1e-14);

  // On the band the measure is the integral of eta.
  const double measure = p.energy.band().measure();
  ASSERT_GT(measure, 0.1);
  const auto band = matrix({.mass = 0, .band_mass = 5, .band_stiffness = 2});
  EXPECT_NEAR(one.dot(band * one), 5 * measure, 1e-12);
  EXPECT_NEAR(u.dot(matrix({.mass = 0, .band_stiffness = 2}) * v), 2 * measure * a.dot(b), 1e-12);
}

TYPED_TEST(MetricMatrix, IsTheLumpedMassWithoutStiffness) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid = hanging_grid<Dim>(0.3);
  const Problem<Dim> p(grid, linear_fields(grid), linear_fields(grid));
  const Eigen::MatrixXd m = metric_matrix<Dim>(grid, p.unknowns, p.energy, {});
  const std::vector<double> mass = lumped_mass(grid);
  ASSERT_EQ(static_cast<std::size_t>(m.rows()), mass.size());
  Vector expected(m.rows());
  for (Eigen::Index i = 0; i < m.rows(); ++i) expected[i] = mass[grid.free_index(p.unknowns.nodes()[i])];
  EXPECT_NEAR((m - Eigen::MatrixXd(expected.asDiagonal())).norm(), 0, 1e-15);
}

TYPED_TEST(MetricMatrix, LeavesFixedNodesOut) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid = hanging_grid<Dim>(0.3);
  ProblemOptions options;
  options.energy.boundary = BoundaryCondition::dirichlet;
  const Problem<Dim> fixed(grid, linear_fields(grid), linear_fields(grid), options);
  const Problem<Dim> free(grid, linear_fields(grid), linear_fields(grid));
  const MetricWeights w{.mass = 1, .stiffness = 2, .band_mass = 3, .band_stiffness = 4};
  const auto part = metric_matrix<Dim>(grid, fixed.unknowns, fixed.energy, w);
  const auto all = metric_matrix<Dim>(grid, free.unknowns, free.energy, w);
  ASSERT_LT(part.rows(), all.rows());
  // The matrix is the submatrix of the unknowns that are not fixed.
  std::vector<Index> kept;
  for (Index i = 0, j = 0; j < static_cast<Index>(fixed.unknowns.nodes().size()); ++i)
    if (free.unknowns.nodes()[i] == fixed.unknowns.nodes()[j]) {
      kept.push_back(i);
      ++j;
    }
  for (Index j = 0; j < part.cols(); ++j)
    for (Index i = 0; i < part.rows(); ++i) ASSERT_NEAR(part.coeff(i, j), all.coeff(kept[i], kept[j]), 1e-14);
}

// The purpose of the metric h1_band: along smooth fields it approximates the energy's second derivative at the
// identity.
TYPED_TEST(MetricMatrix, OfTheEnergyBoundsItsVolumeTermFromAbove) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid = hanging_grid<Dim>(0.3);
  for (const std::string_view density : {"simplified", "symmetric_dirichlet"}) {
    SCOPED_TRACE(density);
    ProblemOptions options;
    options.energy.terms.model("volume"_term) = density;
    const Problem<Dim> p(grid, linear_fields(grid), linear_fields(grid), options);
    const TermValues weights = only("volume"_term);
    const auto m = metric_matrix<Dim>(grid, p.unknowns, p.energy, stiffness_of_energy<Dim>(p.energy.terms(), weights));
    const auto id = at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
    for (unsigned seed = 1; seed < 4; ++seed) {
      const double t = 1e-4;
      const auto phi = deformed(grid, t, seed);
      const double second = 2 * p.value(phi, "volume"_term) / (t * t);
      double norm = 0;
      for (int k = 0; k < Dim; ++k) {
        Vector u(m.rows());
        for (Eigen::Index i = 0; i < u.size(); ++i) {
          const Index node = p.unknowns.nodes()[i];
          u[i] = (phi[node][k] - id[node][k]) / t;
        }
        norm += u.dot(m * u);
      }
      EXPECT_LT(second, norm) << seed;
      EXPECT_GT(second, 0.1 * norm) << seed;
    }
  }
}

}  // namespace
}  // namespace shellmatch::test
