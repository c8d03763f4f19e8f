// Floating-point operations of the energies' loops, counted by compiling these same loops with a Pack of one
// lane that counts (tests/bench/counted/). Prints one line of JSON: for each loop the operations for one active
// quadrature point of the band, or for one element. Multiplications and additions that are fused count as
// two.
//
// Not seen are the look-up of the template's values, which is counted by hand below, and what works on plain
// doubles: in Newton's volume term, the eigenvectors by Eigen.

#include "base/error.h"
#include "base/parallel.h"
#include "energies/hessian/energy_hessian.h"
#include "energies/assembly/matching_energy.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/grid/test_grids.h"

#include <fmt/core.h>

#include <cmath>

namespace {

using namespace shellmatch;
using autodiff::counted;
using autodiff::OperationCount;

/// Additions and multiplications of GeometryField's look-up of one point in quadratic splines: three
/// coefficients become one along each axis, for the values and for what has been derived.
OperationCount look_up(bool with_derivatives) {
  OperationCount c;
  long sums = 0;
  for (int axis = 0, left = 9; axis < 3; ++axis, left /= 3) sums += left * (with_derivatives ? axis + 2 : 1);
  c.multiplications = 3 * sums * GeometryField<3>::n_values;
  c.additions = 2 * sums * GeometryField<3>::n_values;
  return c;
}

OperationCount operator+(const OperationCount& a, const OperationCount& b) {
  return {a.additions + b.additions, a.multiplications + b.multiplications, a.divisions + b.divisions,
          a.roots + b.roots, a.exponentials + b.exponentials};
}

/// Distance, normal and a positive definite root at any place; which does not matter to the count.
GeometryField<3> field_of(const test::ExactShape<3>& shape) {
  return GeometryField<3>([shape](const Vec<3>& x) {
    const Vec<3> n = shape.normal(x);
    return GeometryField<3>::Values{shape.distance(x), n[0], n[1], n[2], 2.0, 0.1, 0.1, 2.0, 0.1, 2.0};
  });
}

/// A sphere and an ellipsoid on a grid, at a deformation that folds nothing.
struct Problem {
  Octree<3> grid;
  GeometryPair<3> geometry;
  EnergyOptions options;
  Unknowns<3> unknowns;
  MatchingEnergy<3> energy;
  EnergyHessian<3> hessian;
  std::vector<Vec<3>> phi;
  std::vector<double> gradient;

  Problem()
      : grid(test::shape_grid<3>(3, 5, test::sphere<3>(0.25).distance)),
        geometry{field_of(test::sphere<3>(0.25)), field_of(test::ellipsoid<3>(Vec<3>(0.22, 0.25, 0.3))), false},
        unknowns(grid, options.boundary),
        energy(unknowns, geometry, options, 2 * grid.finest_side(), options.quadrature_order),
        hessian(energy, unknowns),
        gradient(unknowns.size()) {
    for (Index node = 0; node < grid.n_nodes(); ++node) {
      const Vec<3> x = grid.node_position(node);
      phi.push_back(x + 0.01 * Vec<3>(x[1] * x[2], x[0] * x[2], x[0] * x[0]));
    }
  }

  OperationCount evaluate(const TermValues& weights, bool with_gradient) {
    const OperationCount before = counted;
    TermValues values;
    SHELLMATCH_CHECK(energy.evaluate(phi, weights, values, with_gradient ? std::span(gradient) : std::span<double>()),
                     "the energy cannot be evaluated");
    return counted - before;
  }
  OperationCount assemble(const TermValues& weights) {
    const OperationCount before = counted;
    hessian.assemble(phi, weights);
    return counted - before;
  }
};

/// For one of n things on average: the first terms of sums over chunks and elements are not counted.
OperationCount each(const OperationCount& total, std::size_t n) {
  const auto share = [n](long x) { return std::lround(static_cast<double>(x) / static_cast<double>(n)); };
  return {share(total.additions), share(total.multiplications), share(total.divisions), share(total.roots),
          share(total.exponentials)};
}

void print(const char* name, const OperationCount& c, bool last = false) {
  // A division, a root and an exponential count as one each.
  fmt::print(R"("{}": {{"flops": {}, "divisions": {}, "roots": {}, "exponentials": {}}}{})", name,
             c.additions + c.multiplications + c.divisions + c.roots + c.exponentials, c.divisions, c.roots,
             c.exponentials, last ? "}\n" : ", ");
}

}  // namespace

int main() {
  set_n_threads(1);  // the counter is one for all
  Problem problem;
  TermValues band, volume, barrier;
  band["match"_term] = band["membrane"_term] = band["bending"_term] = 1;
  volume["volume"_term] = 1;
  TermValues band_and_volume = band;
  band_and_volume += volume;
  barrier["barrier"_term] = 1;
  const std::size_t points = problem.energy.band().n_active_points(), elements = problem.unknowns.elements().size();
  const OperationCount newton_volume = problem.assemble(volume);

  // One term at a time goes through the shell (interpolation, its transpose, sums) three times, all at once
  // once.
  OperationCount shell{};
  for (const Term term : {"match"_term, "membrane"_term, "bending"_term}) {
    TermValues alone;
    alone[term] = 1;
    shell = shell + problem.evaluate(alone, true);
  }
  shell = shell - problem.evaluate(band, true);

  fmt::print("{{");
  print("band_value_by_point", each(problem.evaluate(band, false), points) + look_up(false));
  print("band_gradient_by_point", each(problem.evaluate(band, true), points) + look_up(true));
  print("band_gradient_shell_by_point", each(shell, 2 * points) + look_up(true));
  print("volume_value_by_element", each(problem.evaluate(volume, false), elements));
  print("volume_gradient_by_element", each(problem.evaluate(volume, true), elements));
  print("barrier_by_element", each(problem.evaluate(barrier, false), elements));
  print("newton_band_by_point", each(problem.assemble(band_and_volume) - newton_volume, points) + look_up(true));
  print("newton_volume_by_element", each(newton_volume, elements), true);
}
