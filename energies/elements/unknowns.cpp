#include "energies/elements/unknowns.h"

#include "base/error.h"
#include "base/parallel.h"

namespace shellmatch {

template <int Dim>
Unknowns<Dim>::Unknowns(const Octree<Dim>& grid, BoundaryCondition boundary) : grid_(&grid) {
  elements_.reserve(grid.leaves().size());
  for (const Index leaf : grid.leaves())
    elements_.push_back({grid.cell(leaf).nodes, grid.cell(leaf).side(), grid.cell_corner(leaf)});

  // Neighbouring elements, whatever their levels, get unknowns with close numbers: most of what is read around a node
  // is still in the caches.
  std::vector<const HangingNode<Dim>*> hanging_of(static_cast<std::size_t>(grid.n_nodes()), nullptr);
  for (const auto& h : grid.hanging_nodes()) hanging_of[h.node] = &h;
  std::vector<Index> unknown_of(static_cast<std::size_t>(grid.n_nodes()), no_index);
  const auto number_node = [&](Index node) {
    if (unknown_of[node] != no_index) return;
    if (boundary == BoundaryCondition::dirichlet && grid.is_boundary_node(node)) return;
    unknown_of[node] = static_cast<Index>(nodes_.size());
    nodes_.push_back(node);
  };
  nodes_.reserve(grid.free_nodes().size());
  for (const Element<Dim>& element : elements_)
    for (const Index node : element.nodes) {
      if (const auto* h = hanging_of[node])
        for (int p = 0; p < h->n_parents; ++p) number_node(h->parents[p]);
      else number_node(node);
    }

  entries_begin_.reserve(hanging_of.size() + 1);
  for (Index node = 0; node < grid.n_nodes(); ++node) {
    entries_begin_.push_back(entries_.size());
    if (const auto* h = hanging_of[node]) {
      for (int p = 0; p < h->n_parents; ++p)
        if (const Index u = unknown_of[h->parents[p]]; u != no_index)
          entries_.push_back({u, 1.0F / static_cast<float>(h->n_parents)});
    } else if (unknown_of[node] != no_index) {
      entries_.push_back({unknown_of[node], 1.0F});
    }
  }
  entries_begin_.push_back(entries_.size());
}

template <int Dim>
void Unknowns<Dim>::expand(std::span<const double> x, std::vector<Vec<Dim>>& nodal) const {
  SHELLMATCH_CHECK(x.size() == size() && nodal.size() == static_cast<std::size_t>(grid_->n_nodes()),
                   "sizes of unknowns and nodal field");
  parallel_for(
      nodes_.size(),
      [&](std::size_t i) {
        for (int k = 0; k < Dim; ++k) nodal[nodes_[i]][k] = x[Dim * i + k];
      },
      8192);
  // As distribute() of grid/octree/constraints.h, which takes 1.4 times as long: its number of components is a
  // variable.
  const auto hanging = grid_->hanging_nodes();
  parallel_for(
      hanging.size(),
      [&](std::size_t i) {
        const HangingNode<Dim>& h = hanging[i];
        Vec<Dim> sum = nodal[h.parents[0]];
        for (int p = 1; p < h.n_parents; ++p) sum += nodal[h.parents[p]];
        nodal[h.node] = sum / h.n_parents;
      },
      8192);
}

template <int Dim>
void Unknowns<Dim>::restrict_to(const std::vector<Vec<Dim>>& nodal, std::span<double> x) const {
  SHELLMATCH_CHECK(x.size() == size() && nodal.size() == static_cast<std::size_t>(grid_->n_nodes()),
                   "sizes of unknowns and nodal field");
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (int k = 0; k < Dim; ++k) x[Dim * i + k] = nodal[nodes_[i]][k];
}

template class Unknowns<2>;
template class Unknowns<3>;

}  // namespace shellmatch
