#include "grid/fields/projection.h"

#include "base/error.h"
#include "base/parallel.h"
#include "grid/octree/constraints.h"
#include "grid/fields/mass.h"
#include "grid/octree/nodal_incidence.h"

#include <bit>

namespace shellmatch {

namespace {

// Relative residual; well below the discretisation error of the gradient.
constexpr double solver_tolerance = 1e-6;

/// Integrals of grad d times each node's shape function, as if hanging nodes were free. In the leaves around it: 1/2
/// [-1 1] along the axis of the derivative and [1/3 1/6] along the others, from the node's own corner. Each node sums
/// over its leaves, so that no vectors of all elements are stored.
template <int Dim>
std::vector<double> gradient_moments(const Octree<Dim>& grid, const std::vector<double>& nodal_distance) {
  const NodalIncidence<Dim> incidence(grid);
  const auto leaves = grid.leaves();
  std::vector<double> moments(static_cast<std::size_t>(grid.n_nodes()) * Dim);
  parallel_for(static_cast<std::size_t>(grid.n_nodes()), [&](std::size_t node) {
    std::array<double, Dim> sum{};
    for (const auto& e : incidence.leaves_at(static_cast<Index>(node))) {
      const auto& cell = grid.cell(leaves[static_cast<std::size_t>(e.leaf)]);
      std::array<double, n_corners<Dim>> d;  // bit k: on the other side along axis k
      for (int c = 0; c < n_corners<Dim>; ++c) d[c] = nodal_distance[cell.nodes[c ^ e.corner]];
      double factor = 0.5;  // side^Dim of the volume times 1/side of the derivative
      for (int k = 1; k < Dim; ++k) factor *= cell.side() / 6;
      for (int axis = 0; axis < Dim; ++axis) {
        double derivative = 0;
        for (int c = 0; c < n_corners<Dim>; ++c) {
          const int other = c | 1 << axis;
          if (c != other) derivative += (1 << (Dim - 1 - std::popcount(static_cast<unsigned>(c)))) * (d[other] - d[c]);
        }
        sum[axis] += (e.corner >> axis & 1 ? -factor : factor) * derivative;
      }
    }
    for (int axis = 0; axis < Dim; ++axis) moments[node * Dim + axis] = sum[axis];
  });
  return moments;
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim>> project_gradient(const Octree<Dim>& grid, const std::vector<double>& nodal_distance,
                                       MassKind mass) {
  SHELLMATCH_CHECK(nodal_distance.size() == static_cast<std::size_t>(grid.n_nodes()), "size of a nodal field");
  const Constraints<Dim> constraints(grid);
  std::vector<double> b(constraints.n_free() * Dim);
  constraints.condense(gradient_moments(grid, nodal_distance), b, Dim);
  const std::vector<double> lumped = lumped_mass(grid);
  std::vector<double> x(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) x[i] = b[i] / lumped[i / Dim];
  if (mass == MassKind::consistent) MassOperator<Dim>(grid).solve(b, x, Dim, solver_tolerance);

  std::vector<Vec<Dim>> gradient(grid.n_nodes());
  constraints.expand(x, components_of(gradient), Dim);
  return gradient;
}

template <int Dim>
void normalise(std::vector<Vec<Dim>>& nodal, double smallest) {
  parallel_for(nodal.size(), [&](std::size_t i) {
    const double length = nodal[i].norm();
    nodal[i] = length >= smallest ? Vec<Dim>(nodal[i] / length) : Vec<Dim>(Vec<Dim>::Zero());
  });
}

template <int Dim>
std::vector<Vec<Dim>> nodal_normals(const Octree<Dim>& grid, const std::vector<double>& nodal_distance, MassKind mass) {
  auto normals = project_gradient(grid, nodal_distance, mass);
  normalise(normals);
  distribute(grid, normals);
  return normals;
}

SHELLMATCH_2D_3D(project_gradient);
SHELLMATCH_2D_3D(normalise);
SHELLMATCH_2D_3D(nodal_normals);

}  // namespace shellmatch
