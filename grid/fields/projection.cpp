#include "grid/fields/projection.h"

#include "base/error.h"
#include "base/parallel.h"
#include "grid/octree/constraints.h"
#include "grid/fields/mass.h"

namespace shellmatch {

namespace {

// Relative residual; well below the discretisation error of the gradient.
constexpr double solver_tolerance = 1e-6;

// Integrals over a cell of d's derivative along `axis` times each shape function: the tensor product of
// 1/2 [-1 1; -1 1] along the axis and of mass matrices [1/3 1/6; 1/6 1/3] along the others.
template <int Dim>
std::array<double, n_corners<Dim>> derivative_moments(std::array<double, n_corners<Dim>> d, int axis) {
  for (int k = 0; k < Dim; ++k)
    for (int c = 0; c < n_corners<Dim>; ++c) {
      if ((c >> k) & 1) continue;
      const int upper = c | (1 << k);
      const double a = d[c], b = d[upper];
      d[c] = k == axis ? 0.5 * (b - a) : a / 3 + b / 6;
      d[upper] = k == axis ? 0.5 * (b - a) : a / 6 + b / 3;
    }
  return d;
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim>> project_gradient(const Octree<Dim>& grid, const std::vector<double>& nodal_distance,
                                       MassKind mass) {
  SHELLMATCH_CHECK(nodal_distance.size() == static_cast<std::size_t>(grid.n_nodes()),
                   "size of a nodal field");
  const MassOperator<Dim> op(grid);
  const auto leaves = grid.leaves();
  std::vector<double> elements(leaves.size() * n_corners<Dim> * Dim);
  parallel_for(leaves.size(), [&](std::size_t l) {
    const auto& cell = grid.cell(leaves[l]);
    double factor = 1;  // side^Dim of the volume times 1/side of the derivative
    for (int k = 1; k < Dim; ++k) factor *= cell.side();
    std::array<double, n_corners<Dim>> d;
    for (int c = 0; c < n_corners<Dim>; ++c) d[c] = factor * nodal_distance[cell.nodes[c]];
    for (int axis = 0; axis < Dim; ++axis) {
      const auto moments = derivative_moments<Dim>(d, axis);
      for (int c = 0; c < n_corners<Dim>; ++c) elements[(l * n_corners<Dim> + c) * Dim + axis] = moments[c];
    }
  });
  std::vector<double> b(op.constraints().n_free() * Dim), x(b.size());
  op.sum_elements(elements, b, Dim);
  elements = std::vector<double>();  // freed before the solver allocates as much
  for (std::size_t i = 0; i < b.size(); ++i) x[i] = b[i] / op.lumped()[i / Dim];
  if (mass == MassKind::consistent) op.solve(b, x, Dim, solver_tolerance);

  std::vector<Vec<Dim>> gradient(grid.n_nodes());
  op.constraints().expand(x, components_of(gradient), Dim);
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
std::vector<Vec<Dim>> nodal_normals(const Octree<Dim>& grid, const std::vector<double>& nodal_distance,
                                    MassKind mass) {
  auto normals = project_gradient(grid, nodal_distance, mass);
  normalise(normals);
  distribute(grid, normals);
  return normals;
}

template std::vector<Vec<2>> project_gradient<2>(const Octree<2>&, const std::vector<double>&, MassKind);
template std::vector<Vec<3>> project_gradient<3>(const Octree<3>&, const std::vector<double>&, MassKind);
template void normalise<2>(std::vector<Vec<2>>&, double);
template void normalise<3>(std::vector<Vec<3>>&, double);
template std::vector<Vec<2>> nodal_normals<2>(const Octree<2>&, const std::vector<double>&, MassKind);
template std::vector<Vec<3>> nodal_normals<3>(const Octree<3>&, const std::vector<double>&, MassKind);

}  // namespace shellmatch
