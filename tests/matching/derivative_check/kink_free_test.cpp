// The energy is only smooth piece by piece. Holding back the nodes around points that would pass a face keeps a
// direction on one piece; without it the remainder shows the kinks.

#include "matching/derivative_check/kink_free.h"

#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

using namespace test;

TEST(KinkFree, RoomIsTheDistanceToTheNearestFace) {
  const Octree<2> grid(2);
  const Vec<2> distance = distance_to_cell_faces<2>(grid, Vec<2>(0.26, 0.4));
  EXPECT_NEAR(distance[0], 0.01, 1e-15);
  EXPECT_NEAR(distance[1], 0.1, 1e-15);
  // Outside, positions are projected back: the domain's boundary is the only face.
  EXPECT_NEAR(distance_to_cell_faces<2>(grid, Vec<2>(-0.3, 0.4))[0], 0.3, 1e-15);
  EXPECT_NEAR(distance_to_cell_faces<2>(grid, Vec<2>(1.2, 0.4))[0], 0.2, 1e-15);
}

template <int Dim>
void check_direction() {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const Problem<Dim> p(grid, exact_fields<Dim>(grid, sphere<Dim>(0.28)),
                       exact_fields<Dim>(grid, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24))));
  const CeresEvaluator<Dim> costs(p.energy);
  const auto phi = deformed<Dim>(grid, 0.04, 7);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-1, 1);
  std::vector<double> v(p.unknowns.size());
  for (double& component : v) component = grid.finest_side() * noise(random);
  const std::vector<double> unheld = v;

  const double reach = 0.01;
  const HeldPoints held = hold_at_kinks<Dim>(p.unknowns, costs, p.target, grid, phi, reach, v);
  EXPECT_GT(held.n_points, 0u);
  EXPECT_GT(held.n_nodes, 0u);
  std::size_t n_zero = 0, n_kept = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    n_zero += v[i] == 0;
    n_kept += v[i] == unheld[i];
  }
  EXPECT_EQ(n_zero, held.n_nodes * Dim);
  EXPECT_EQ(n_kept + n_zero, v.size());
  EXPECT_GT(n_kept, v.size() / 4);

  // Every point reads the same cell all along.
  std::vector<double> x(v.size());
  p.unknowns.restrict_to(phi, x);
  const auto cells_at = [&](const std::vector<double>& direction, double t) {
    std::vector<double> y = x;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += t * direction[i];
    auto moved = phi;
    p.unknowns.expand(y, moved);
    std::vector<Index> cells;
    for (std::size_t e = 0; e < p.unknowns.elements().size(); ++e)
      for (const int q : costs.band_points(e)) cells.push_back(grid.locate(costs.position(costs.dofs_of(e, moved), q)));
    return cells;
  };
  EXPECT_EQ(cells_at(v, 0.0), cells_at(v, reach));
  EXPECT_EQ(cells_at(v, 0.0), cells_at(v, -reach));
  EXPECT_NE(cells_at(unheld, 0.0), cells_at(unheld, reach));
}
TEST(KinkFree, HeldDirectionsKeepEveryPointInItsCellInThePlane) { check_direction<2>(); }
TEST(KinkFree, HeldDirectionsKeepEveryPointInItsCellInSpace) { check_direction<3>(); }

}  // namespace
}  // namespace shellmatch
