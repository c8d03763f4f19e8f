#include "energies/elements/band.h"

#include "grid/fields/bump.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

// Integral of eta_1(t) t^2 by the trapezoidal rule, which converges faster than any power for a bump.
double second_moment() {
  double sum = 0;
  const int n = 200;
  for (int i = -n; i <= n; ++i) sum += bump(double(i) / n, 1) * i * i / (double(n) * n * n);
  return sum;
}

// Around a plane, where nothing is interpolated wrongly, the band's moments are those of eta: 1, 0 and a multiple
// of sigma^2.
template <int Dim>
void check_moments() {
  const Octree<Dim> grid(4);
  CoefficientFields<Dim> plane;
  for (Index node = 0; node < grid.n_nodes(); ++node) {
    plane.distance.push_back(grid.node_position(node)[0] - 0.47);
    plane.normal.push_back(Vec<Dim>::Unit(0));
    plane.root.push_back(pack_symmetric<Dim>(Mat<Dim>::Identity()));
  }
  const Problem<Dim> p(grid, plane, plane, {.sigma_over_h = 3, .points_per_direction = 4});
  const Band<Dim>& band = p.energy.band();
  const double sigma = 3.0 / 16;
  double moments[3] = {0, 0, 0};
  std::size_t n_active = 0, n_elements = 0;
  for (std::size_t b = 0; b < band.batches().size(); ++b) {
    n_elements += static_cast<std::size_t>(band.batches()[b].n_elements);
    for (std::size_t q = 0; q < p.energy.shape().points.size(); ++q)
      for (int lane = 0; lane < Band<Dim>::n_lanes; ++lane) {
        const auto& point = band.point(b, q);
        const double weight = point.weight[lane], d1 = point.reference(0)[lane];
        n_active += weight > 0;
        for (int k = 0; k < 3; ++k) moments[k] += weight * std::pow(d1 / sigma, k);
        EXPECT_EQ(weight > 0, lane < band.batches()[b].n_elements && std::abs(d1) < sigma);
      }
  }
  const std::size_t of_block = cells_per_block(p.unknowns.elements().size());
  std::size_t next = 0;
  for (std::size_t block = 0; block < p.energy.cell_blocks().size(); ++block) {
    const auto [first, last] = band.batches_of(block);
    EXPECT_EQ(first, next);
    next = last;
    for (std::size_t b = first; b < last; ++b)
      for (const Index e : band.batches()[b].element) EXPECT_EQ(static_cast<std::size_t>(e) / of_block, block);
  }
  EXPECT_EQ(next, band.batches().size());
  EXPECT_NEAR(moments[0], 1, 1e-3);
  EXPECT_NEAR(moments[1], 0, 1e-3);
  EXPECT_NEAR(moments[2], second_moment(), 1e-3);
  EXPECT_NEAR(band.measure(), moments[0], 1e-14);
  EXPECT_EQ(band.n_active_points(), n_active);
  EXPECT_EQ(band.n_elements(), n_elements);
  EXPECT_LT(n_elements, p.unknowns.elements().size());
}

TEST(Band, HasTheMomentsOfTheBump) {
  check_moments<2>();
  check_moments<3>();
}

}  // namespace
}  // namespace shellmatch
