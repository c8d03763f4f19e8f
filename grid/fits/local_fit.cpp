#include "grid/fits/local_fit.h"

#include "base/error.h"
#include "base/parallel.h"
#include "grid/fits/lattice_fit.h"
#include "grid/fits/nearest_nodes.h"
#include "grid/fits/quadratic_fit.h"

#include <algorithm>

namespace shellmatch {

template <int Dim>
std::size_t n_neighbours(const CoefficientOptions& options) {
  // 12 and 32 are complete shells of the regular lattice: all nodes within two cells.
  const int wanted = options.neighbours > 0 ? options.neighbours : (Dim == 2 ? 12 : 32);
  return static_cast<std::size_t>(std::max(wanted, QuadraticFit<Dim, 1>::n_unknowns - 1));
}

namespace {

template <int Fields>
using FieldPointers = std::array<const double*, Fields>;

// Returns one Hessian for each field.
template <int Dim, int Fields>
std::array<SymmetricComponents<Dim>, Fields> fit_at(const Octree<Dim>& grid, const NearestNodes<Dim>& nodes,
                                                    const FieldPointers<Fields>& fields, Index node,
                                                    std::size_t n_others, double exponent,
                                                    typename NearestNodes<Dim>::Scratch& scratch) {
  const auto free = grid.free_nodes();
  std::array<double, Dim> centre;
  for (int k = 0; k < Dim; ++k) centre[k] = grid.node_coord(node)[k];
  while (true) {
    const std::size_t n = std::min(n_others, free.size() - 1);
    const auto [nearest, farthest] = nodes.find(centre, n, scratch);
    const double per_radius = 1 / std::sqrt(farthest);
    QuadraticFit<Dim, Fields> fit;
    for (const auto& [position, square] : scratch.ball) {
      const Index other = free[position];
      Vec<Dim> x;
      for (int k = 0; k < Dim; ++k) x[k] = (grid.node_coord(other)[k] - grid.node_coord(node)[k]) * per_radius;
      // Differences avoid cancellation where the values are large.
      std::array<double, Fields> values;
      for (int f = 0; f < Fields; ++f) values[f] = fields[f][other] - fields[f][node];
      // The node itself has the weight of its nearest neighbour.
      const double weight = exponent == 0 ? 1.0 : std::pow(std::max(square, nearest) / farthest, -0.5 * exponent);
      fit.add(x, values, weight);
    }
    if (fit.factorise()) {
      const double per_length = static_cast<double>(1 << Octree<Dim>::max_level) * per_radius;
      std::array<SymmetricComponents<Dim>, Fields> hessians;
      for (int f = 0; f < Fields; ++f) {
        hessians[f] = fit.hessian(f);
        for (double& v : hessians[f]) v *= per_length * per_length;
      }
      return hessians;
    }
    SHELLMATCH_CHECK(n + 1 < free.size(), "the grid is too coarse for a quadratic through its nodes");
    n_others += n_others / 2;
  }
}

template <int Dim, int Fields>
std::array<Hessians<Dim>, Fields> fit_all(const Octree<Dim>& grid, const FieldPointers<Fields>& fields,
                                          const CoefficientOptions& options, std::span<const Index> nodes) {
  const std::size_t n_others = n_neighbours<Dim>(options);
  const NearestNodes<Dim> free_nodes(grid);
  const LatticeFit<Dim> lattice(grid, n_others, options.fit_weight);
  std::array<Hessians<Dim>, Fields> hessians;
  for (auto& h : hessians) h.resize(nodes.size());
  parallel_chunks(nodes.size(), 512, [&](const Chunk& chunk) {
    typename NearestNodes<Dim>::Scratch scratch;
    std::vector<Index> lattice_nodes;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      SHELLMATCH_CHECK(grid.free_index(nodes[i]) != no_index, "quadratics are fitted at free nodes");
      if (const double side = lattice.find_neighbours(nodes[i], lattice_nodes); side > 0) {
        for (int f = 0; f < Fields; ++f)
          hessians[f][i] =
              lattice.hessian({fields[f], static_cast<std::size_t>(grid.n_nodes())}, nodes[i], side, lattice_nodes);
        continue;
      }
      const auto at_node =
          fit_at<Dim, Fields>(grid, free_nodes, fields, nodes[i], n_others, options.fit_weight, scratch);
      for (int f = 0; f < Fields; ++f) hessians[f][i] = at_node[f];
    }
  });
  return hessians;
}

}  // namespace

template <int Dim>
Hessians<Dim> fit_hessians(const Octree<Dim>& grid, const std::vector<double>& nodal, const CoefficientOptions& options,
                           std::span<const Index> nodes) {
  SHELLMATCH_CHECK(nodal.size() == static_cast<std::size_t>(grid.n_nodes()), "size of a nodal field");
  return fit_all<Dim, 1>(grid, {nodal.data()}, options, nodes)[0];
}

template <int Dim>
std::array<Hessians<Dim>, 2> fit_hessians(const Octree<Dim>& grid, const std::array<std::vector<double>, 2>& nodal,
                                          const CoefficientOptions& options, std::span<const Index> nodes) {
  for (const auto& field : nodal)
    SHELLMATCH_CHECK(field.size() == static_cast<std::size_t>(grid.n_nodes()), "size of a nodal field");
  return fit_all<Dim, 2>(grid, {nodal[0].data(), nodal[1].data()}, options, nodes);
}

SHELLMATCH_2D_3D(n_neighbours);
#define SHELLMATCH_INSTANTIATE(Dim)                                                                                   \
  template Hessians<Dim> fit_hessians<Dim>(const Octree<Dim>&, const std::vector<double>&, const CoefficientOptions&, \
                                           std::span<const Index>);                                                   \
  template std::array<Hessians<Dim>, 2> fit_hessians<Dim>(const Octree<Dim>&,                                         \
                                                          const std::array<std::vector<double>, 2>&,                  \
                                                          const CoefficientOptions&, std::span<const Index>);
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
