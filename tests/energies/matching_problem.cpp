#include "tests/energies/matching_problem.h"

#include "grid/octree/constraints.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shellmatch::test {

TermValues only(Term term) {
  TermValues w;
  w[term] = 1;
  return w;
}

template <int Dim>
Octree<Dim> hanging_grid(double radius) {
  return sphere_grid<Dim>(2, Dim == 2 ? 5 : 4, radius, Vec<Dim>::Constant(0.5));
}

template <int Dim>
std::vector<double> sum_elements(const Unknowns<Dim>& unknowns, std::span<const double> element_gradients) {
  const CellBlocks<Dim> cell_blocks(unknowns);
  std::vector<double> sum(unknowns.size(), std::numeric_limits<double>::quiet_NaN());  // as of before
  cell_blocks.for_each([&](const Chunk& cells) {
    cell_blocks.add(cells, element_gradients.data() + cells.begin * n_corners<Dim> * Dim, sum);
  });
  return sum;
}

template <int Dim>
std::vector<Vec<Dim>> at_nodes(const Octree<Dim>& grid, const std::function<Vec<Dim>(const Vec<Dim>&)>& field) {
  std::vector<Vec<Dim>> values(grid.n_nodes());
  for (Index node = 0; node < grid.n_nodes(); ++node) values[node] = field(grid.node_position(node));
  distribute(grid, values);
  return values;
}

template <int Dim>
std::function<Vec<Dim>(const Vec<Dim>&)> smooth_field(unsigned seed) {
  std::mt19937 random(seed);
  std::array<Vec<Dim>, Dim> wave;
  for (auto& w : wave) w = random_point<Dim>(random, -4, 4);
  const Vec<Dim> phase = random_point<Dim>(random, 0, 6);
  return [=](const Vec<Dim>& x) {
    Vec<Dim> u;
    for (int k = 0; k < Dim; ++k) u[k] = std::sin(wave[k].dot(x) + phase[k]);
    return u;
  };
}

template <int Dim>
std::vector<Vec<Dim>> deformed(const Octree<Dim>& grid, double amplitude, unsigned seed, bool fixed_boundary) {
  const auto field = smooth_field<Dim>(seed);
  return at_nodes<Dim>(grid, [&](const Vec<Dim>& x) {
    double scale = amplitude;
    if (fixed_boundary)
      for (int k = 0; k < Dim; ++k) scale *= 4 * x[k] * (1 - x[k]);
    return Vec<Dim>(x + scale * field(x));
  });
}

template <int Dim>
CoefficientFields<Dim> linear_fields(const Octree<Dim>& grid) {
  CoefficientFields<Dim> f;
  for (Index node = 0; node < grid.n_nodes(); ++node) {
    const Vec<Dim> x = grid.node_position(node);
    f.distance.push_back(x.sum() / Dim - 0.3 - 0.5 * x[0]);
    f.normal.push_back(Vec<Dim>::LinSpaced(-0.3, 0.9) + 0.6 * x.reverse());
    f.root.push_back(pack_symmetric<Dim>(1.5 * Mat<Dim>::Identity() + 0.3 * x * Vec<Dim>::Ones().transpose()));
  }
  return f;
}

template <int Dim>
GeometryField<Dim> field(const Octree<Dim>& grid, const CoefficientFields<Dim>& nodal, bool smooth) {
  if (!smooth) return {grid, nodal.distance, nodal.normal, nodal.root};
  return GeometryField<Dim>::smooth(grid, nodal.distance, nodal.normal, nodal.root);
}

template <int Dim>
Problem<Dim>::Problem(const Octree<Dim>& g, CoefficientFields<Dim> r, CoefficientFields<Dim> t, const ProblemOptions& o)
    : grid(g),
      reference(std::move(r)),
      target_values(std::move(t)),
      options(o.energy),
      unknowns(g, o.energy.boundary),
      geometry{field(g, reference, o.smooth), field(g, target_values, o.smooth), o.root_is_inverse},
      sigma(o.sigma_over_h * g.finest_side()),
      terms(std::make_shared<EnergyTerms<Dim>>(options)),
      energy(unknowns, geometry, terms, sigma, o.points_per_direction) {}

template <int Dim>
std::optional<TermValues> Problem<Dim>::values(const std::vector<Vec<Dim>>& phi, const TermValues& weights) const {
  TermValues v;
  if (!energy.evaluate(phi, weights, v, {})) return {};
  return v;
}

template <int Dim>
double Problem<Dim>::value(const std::vector<Vec<Dim>>& phi, Term term) const {
  const auto v = values(phi, only(term));
  return v ? (*v)[term] : std::nan("");
}

template <int Dim>
std::vector<double> Problem<Dim>::gradient(const std::vector<Vec<Dim>>& phi, const TermValues& weights) const {
  TermValues v;
  std::vector<double> g(unknowns.size());
  EXPECT_TRUE(energy.evaluate(phi, weights, v, g));
  return g;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                                  \
  template Octree<Dim> hanging_grid<Dim>(double);                                                                    \
  template std::vector<double> sum_elements<Dim>(const Unknowns<Dim>&, std::span<const double>);                     \
  template std::vector<Vec<Dim>> at_nodes<Dim>(const Octree<Dim>&, const std::function<Vec<Dim>(const Vec<Dim>&)>&); \
  template std::function<Vec<Dim>(const Vec<Dim>&)> smooth_field<Dim>(unsigned);                                     \
  template std::vector<Vec<Dim>> deformed<Dim>(const Octree<Dim>&, double, unsigned, bool);                          \
  template CoefficientFields<Dim> linear_fields<Dim>(const Octree<Dim>&);                                            \
  template GeometryField<Dim> field<Dim>(const Octree<Dim>&, const CoefficientFields<Dim>&, bool);                   \
  template struct Problem<Dim>;
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch::test
