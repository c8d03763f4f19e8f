// The model of the second derivative: symmetric and positive semidefinite, and exact where nothing has to be removed.

#include "energies/hessian/energy_hessian.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

using namespace test;

template <int Dim>
void check_energy_hessian() {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const Problem<Dim> p(grid, exact_fields<Dim>(grid, sphere<Dim>(0.28)), exact_fields<Dim>(grid, sphere<Dim>(0.28)));
  const auto phi = deformed<Dim>(grid, 0.01, 3);
  EnergyHessian<Dim> hessian(p.energy, p.unknowns);
  TermValues weights;
  for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = 1;
  hessian.assemble(phi, weights);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const std::size_t n = p.unknowns.size();
  std::vector<double> x(n), y(n), hx(n), hy(n), z(n);
  for (int trial = 0; trial < 5; ++trial) {
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = normal(random);
      y[i] = normal(random);
    }
    hessian.apply(x, hx);
    hessian.apply(y, hy);
    double xhy = 0, yhx = 0, xhx = 0;
    for (std::size_t i = 0; i < n; ++i) {
      xhy += x[i] * hy[i];
      yhx += y[i] * hx[i];
      xhx += x[i] * hx[i];
    }
    EXPECT_NEAR(xhy, yhx, 1e-6 * xhx);
    EXPECT_GT(xhx, 0);
    hessian.precondition(x, z);
    double xz = 0;
    for (std::size_t i = 0; i < n; ++i) xz += x[i] * z[i];
    EXPECT_GT(xz, 0);
  }
}
TEST(EnergyHessian, IsSymmetricAndPositiveInThePlane) { check_energy_hessian<2>(); }
TEST(EnergyHessian, IsSymmetricAndPositiveInSpace) { check_energy_hessian<3>(); }

// A uniform stretch, for which the energy is known.
TEST(EnergyHessian, VolumePartIsTheSecondDerivative) {
  const Octree<3> grid(2);
  ProblemOptions options;
  options.energy.terms.model("volume"_term) = "simplified";
  const Problem<3> p(grid, exact_fields<3>(grid, sphere<3>(0.28)), exact_fields<3>(grid, sphere<3>(0.28)), options);
  const auto phi = at_nodes<3>(grid, [](const Vec<3>& x) { return x; });
  EnergyHessian<3> hessian(p.energy, p.unknowns);
  const TermValues weights = only("volume"_term);
  hessian.assemble(phi, weights);
  // u = t (x, 0, 0): W(I + t e1 e1^T) = t^2 (mu + lambda/2), so u.H u = 2 (mu + lambda/2) = 3 on the unit
  // cube.
  std::vector<double> u(p.unknowns.size(), 0.0), hu(u.size());
  for (std::size_t i = 0; i < p.unknowns.nodes().size(); ++i) u[3 * i] = grid.node_position(p.unknowns.nodes()[i])[0];
  hessian.apply(u, hu);
  double uhu = 0;
  for (std::size_t i = 0; i < u.size(); ++i) uhu += u[i] * hu[i];
  EXPECT_NEAR(uhu, 3, 1e-5);
}

}  // namespace
}  // namespace shellmatch
