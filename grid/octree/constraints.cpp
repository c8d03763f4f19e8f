#include "grid/octree/constraints.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>

namespace shellmatch {

template <int Dim>
void distribute(const Octree<Dim>& grid, std::span<double> nodal, int n_components) {
  SHELLMATCH_CHECK(nodal.size() == static_cast<std::size_t>(grid.n_nodes()) * n_components, "size of a nodal field");
  const auto hanging = grid.hanging_nodes();
  parallel_for(hanging.size(), [&](std::size_t i) {
    const HangingNode<Dim>& h = hanging[i];
    const double weight = 1.0 / h.n_parents;
    for (int k = 0; k < n_components; ++k) {
      double sum = 0;
      for (int p = 0; p < h.n_parents; ++p) sum += nodal[static_cast<std::size_t>(h.parents[p]) * n_components + k];
      nodal[static_cast<std::size_t>(h.node) * n_components + k] = weight * sum;
    }
  });
}

template <int Dim>
Constraints<Dim>::Constraints(const Octree<Dim>& grid) : grid_(&grid), first_(n_free() + 1, 0) {
  for (const auto& h : grid.hanging_nodes())
    for (int p = 0; p < h.n_parents; ++p) ++first_[grid.free_index(h.parents[p]) + 1];
  for (std::size_t i = 0; i < n_free(); ++i) first_[i + 1] += first_[i];
  entries_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const auto& h : grid.hanging_nodes())
    for (int p = 0; p < h.n_parents; ++p) entries_[next[grid.free_index(h.parents[p])]++] = {h.node, 1.0 / h.n_parents};
}

template <int Dim>
void Constraints<Dim>::expand(std::span<const double> free, std::span<double> nodal, int n_components) const {
  SHELLMATCH_CHECK(free.size() == n_free() * n_components, "size of a vector of free values");
  const auto nodes = grid_->free_nodes();
  SHELLMATCH_CHECK(nodal.size() == static_cast<std::size_t>(grid_->n_nodes()) * n_components, "size of a nodal field");
  parallel_for(nodes.size(), [&](std::size_t i) {
    std::copy_n(&free[i * n_components], n_components, &nodal[static_cast<std::size_t>(nodes[i]) * n_components]);
  });
  distribute(*grid_, nodal, n_components);
}

template <int Dim>
void Constraints<Dim>::pick(std::span<const double> nodal, std::span<double> free, int n_components) const {
  SHELLMATCH_CHECK(free.size() == n_free() * n_components, "size of a vector of free values");
  SHELLMATCH_CHECK(nodal.size() == static_cast<std::size_t>(grid_->n_nodes()) * n_components, "size of a nodal field");
  const auto nodes = grid_->free_nodes();
  parallel_for(nodes.size(), [&](std::size_t i) {
    std::copy_n(&nodal[static_cast<std::size_t>(nodes[i]) * n_components], n_components, &free[i * n_components]);
  });
}

template <int Dim>
void Constraints<Dim>::condense(std::span<const double> nodal, std::span<double> free, int n_components) const {
  pick(nodal, free, n_components);
  parallel_for(n_free(), [&](std::size_t i) {
    for (std::size_t e = first_[i]; e < first_[i + 1]; ++e)
      for (int k = 0; k < n_components; ++k)
        free[i * n_components + k] +=
            entries_[e].weight * nodal[static_cast<std::size_t>(entries_[e].hanging) * n_components + k];
  });
}

template <int Dim>
void Constraints<Dim>::condense(std::span<double> nodal, int n_components) const {
  SHELLMATCH_CHECK(nodal.size() == static_cast<std::size_t>(grid_->n_nodes()) * n_components, "size of a nodal field");
  const auto nodes = grid_->free_nodes();
  // Only free nodes are written and only hanging nodes are read, so the threads do not conflict.
  parallel_for(nodes.size(), [&](std::size_t i) {
    for (std::size_t e = first_[i]; e < first_[i + 1]; ++e)
      for (int k = 0; k < n_components; ++k)
        nodal[static_cast<std::size_t>(nodes[i]) * n_components + k] +=
            entries_[e].weight * nodal[static_cast<std::size_t>(entries_[e].hanging) * n_components + k];
  });
  for (const auto& h : grid_->hanging_nodes())
    std::fill_n(&nodal[static_cast<std::size_t>(h.node) * n_components], n_components, 0.0);
}

SHELLMATCH_2D_3D(distribute);
template class Constraints<2>;
template class Constraints<3>;

}  // namespace shellmatch
