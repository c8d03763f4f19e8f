#include "matching/shape_fields.h"

#include "base/parallel.h"
#include "grid/constraints.h"
#include "grid/elements.h"
#include "grid/fast_marching.h"

#include <functional>

namespace shellmatch {

namespace {

/// The finite element function with these values at the free nodes.
template <int Dim>
std::vector<double> conforming(const Octree<Dim>& grid, std::vector<double> nodal) {
  distribute(grid, nodal);
  return nodal;
}

}  // namespace

template <int Dim>
void ShapeFields<Dim>::compute_distances(const Octree<Dim>& grid) {
  for (int s = 0; s < 2; ++s) {
    std::vector<double>& values = distances_[s];
    if (method_ == DistanceMethod::fast_marching) {
      values = march_distance<Dim>(grid, std::cref(*shapes_[s]));
      continue;
    }
    const std::size_t known = values.size();
    values.resize(static_cast<std::size_t>(grid.n_nodes()));
    parallel_for(values.size() - known, [&](std::size_t i) {
      values[known + i] = (*shapes_[s])(grid.node_position(static_cast<Index>(known + i)));
    }, 256);
  }
}

template <int Dim>
CoefficientPair<Dim> ShapeFields<Dim>::coefficients(const Octree<Dim>& grid, const ExperimentOptions& options) const {
  const auto compute =
      reads_shape_operators(options.energy) ? compute_shape_operator_pair<Dim> : compute_coefficient_pair<Dim>;
  return compute(grid, conforming(grid, distances_[0]), conforming(grid, distances_[1]), options.coefficients);
}

template <int Dim>
void ShapeFields<Dim>::refine(Octree<Dim>& grid) const {
  grid.refine([&](Index leaf) {
    return meets_surface<Dim>(grid, distances_[0], std::cref(*shapes_[0]), leaf) ||
           meets_surface<Dim>(grid, distances_[1], std::cref(*shapes_[1]), leaf);
  });
}

template <int Dim>
std::vector<Vec<Dim>> identity_map(const Octree<Dim>& grid) {
  std::vector<Vec<Dim>> phi(static_cast<std::size_t>(grid.n_nodes()));
  for (Index i = 0; i < grid.n_nodes(); ++i) phi[i] = grid.node_position(i);
  return phi;
}

template class ShapeFields<2>;
template class ShapeFields<3>;
template std::vector<Vec<2>> identity_map<2>(const Octree<2>&);
template std::vector<Vec<3>> identity_map<3>(const Octree<3>&);

}  // namespace shellmatch
