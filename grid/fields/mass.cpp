#include "grid/fields/mass.h"

#include "base/error.h"
#include "base/parallel.h"

#include <cmath>

namespace shellmatch {

namespace {

constexpr std::size_t chunk = 4096;
constexpr int max_iterations = 200;

template <int Dim>
double volume(const Octree<Dim>& grid, Index leaf) {
  double v = 1;
  for (int k = 0; k < Dim; ++k) v *= grid.cell(leaf).side();
  return v;
}

}  // namespace

template <int Dim>
std::vector<double> lumped_mass(const Octree<Dim>& grid) {
  std::vector<double> nodal(grid.n_nodes(), 0.0), free(grid.free_nodes().size());
  for (const Index leaf : grid.leaves())
    for (const Index node : grid.cell(leaf).nodes) nodal[node] += volume(grid, leaf) / n_corners<Dim>;
  Constraints<Dim>(grid).condense(nodal, free);
  return free;
}

template <int Dim>
MassOperator<Dim>::MassOperator(const Octree<Dim>& grid)
    : grid_(&grid), constraints_(grid), incidence_(grid), lumped_(lumped_mass(grid)) {}

template <int Dim>
void MassOperator<Dim>::sum_elements(std::span<const double> elements, std::span<double> free, int n_components,
                                     std::vector<double>& nodal) const {
  nodal.assign(static_cast<std::size_t>(grid_->n_nodes()) * n_components, 0.0);
  parallel_for(grid_->n_nodes(), [&](std::size_t node) {
    for (const auto& e : incidence_.leaves_at(static_cast<Index>(node)))
      for (int k = 0; k < n_components; ++k)
        nodal[node * n_components + k] +=
            elements[(static_cast<std::size_t>(e.leaf) * n_corners<Dim> + e.corner) * n_components + k];
  });
  constraints_.condense(nodal, free, n_components);
}

template <int Dim>
void MassOperator<Dim>::apply(std::span<const double> x, std::span<double> y, int n_components) const {
  Scratch scratch;
  apply(x, y, n_components, scratch);
}

template <int Dim>
void MassOperator<Dim>::apply(std::span<const double> x, std::span<double> y, int n_components,
                              Scratch& scratch) const {
  auto& [nodal, elements] = scratch;
  nodal.resize(static_cast<std::size_t>(grid_->n_nodes()) * n_components);
  constraints_.expand(x, nodal, n_components);
  const auto leaves = grid_->leaves();
  elements.resize(leaves.size() * n_corners<Dim> * n_components);
  parallel_for(leaves.size(), [&](std::size_t l) {
    const auto& nodes = grid_->cell(leaves[l]).nodes;
    const double v = volume(*grid_, leaves[l]);
    double* element = &elements[l * n_corners<Dim> * n_components];
    for (int k = 0; k < n_components; ++k) {
      std::array<double, n_corners<Dim>> m;
      for (int c = 0; c < n_corners<Dim>; ++c) m[c] = v * nodal[static_cast<std::size_t>(nodes[c]) * n_components + k];
      // The mass matrix of a cell is the tensor power of [1/3 1/6; 1/6 1/3].
      for (int axis = 0; axis < Dim; ++axis)
        for (int c = 0; c < n_corners<Dim>; ++c)
          if (!((c >> axis) & 1)) {
            const double a = m[c], b = m[c | (1 << axis)];
            m[c] = a / 3 + b / 6;
            m[c | (1 << axis)] = a / 6 + b / 3;
          }
      for (int c = 0; c < n_corners<Dim>; ++c) element[c * n_components + k] = m[c];
    }
  });
  sum_elements(elements, y, n_components, nodal);
}

template <int Dim>
int MassOperator<Dim>::solve(std::span<const double> b, std::span<double> x, int n_components, double tolerance) const {
  const std::size_t n = b.size();
  SHELLMATCH_CHECK(x.size() == n && n == lumped_.size() * n_components, "size of a vector of free values");
  const auto preconditioned = [&](std::size_t i, double value) { return value / lumped_[i / n_components]; };
  const auto product = [&](const auto& term) {
    return parallel_sum(n, chunk, 0.0, [&](const Chunk& c) {
      double sum = 0;
      for (std::size_t i = c.begin; i < c.end; ++i) sum += term(i);
      return sum;
    });
  };
  const double goal = tolerance * tolerance * product([&](std::size_t i) { return b[i] * preconditioned(i, b[i]); });

  std::vector<double> r(n), p(n), q(n);
  Scratch scratch;
  apply(x, q, n_components, scratch);
  parallel_for(n, [&](std::size_t i) {
    r[i] = b[i] - q[i];
    p[i] = preconditioned(i, r[i]);
  });
  double rz = product([&](std::size_t i) { return r[i] * preconditioned(i, r[i]); });
  int iteration = 0;
  for (; rz > goal && iteration < max_iterations; ++iteration) {
    apply(p, q, n_components, scratch);
    const double alpha = rz / product([&](std::size_t i) { return p[i] * q[i]; });
    parallel_for(n, [&](std::size_t i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * q[i];
    });
    const double next = product([&](std::size_t i) { return r[i] * preconditioned(i, r[i]); });
    const double beta = next / rz;
    parallel_for(n, [&](std::size_t i) { p[i] = preconditioned(i, r[i]) + beta * p[i]; });
    rz = next;
  }
  return iteration;
}

SHELLMATCH_2D_3D(lumped_mass);
template class MassOperator<2>;
template class MassOperator<3>;

}  // namespace shellmatch
