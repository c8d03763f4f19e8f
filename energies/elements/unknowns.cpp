#include "energies/elements/unknowns.h"

#include "base/error.h"
#include "base/parallel.h"

namespace shellmatch {

template <int Dim>
ShapeTable<Dim>::ShapeTable(int n) : points_per_direction(n) {
  for (const auto& q : gauss_rule<Dim>(n)) {
    Point p{.weight = q.weight, .xi = q.point, .n = {}, .dn = {}};
    for (int c = 0; c < n_corners<Dim>; ++c) {
      std::array<double, Dim> factor, slope;
      for (int k = 0; k < Dim; ++k) {
        const bool upper = (c >> k) & 1;
        factor[k] = upper ? p.xi[k] : 1 - p.xi[k];
        slope[k] = upper ? 1.0 : -1.0;
      }
      p.n[c] = 1;
      for (int k = 0; k < Dim; ++k) {
        p.n[c] *= factor[k];
        p.dn[c][k] = 1;
        for (int j = 0; j < Dim; ++j) p.dn[c][k] *= j == k ? slope[j] : factor[j];
      }
    }
    points.push_back(p);
  }
}

template <int Dim>
Unknowns<Dim>::Unknowns(const Octree<Dim>& grid, BoundaryCondition boundary) : grid_(&grid) {
  elements_.reserve(grid.leaves().size());
  for (const Index leaf : grid.leaves())
    elements_.push_back({grid.cell(leaf).nodes, grid.cell(leaf).side(), grid.cell_corner(leaf)});

  // In the order in which the elements meet them: neighbours, of whatever level, have numbers close together, so
  // that what is read around a node is mostly in the caches still.
  std::vector<const HangingNode<Dim>*> hanging_of(static_cast<std::size_t>(grid.n_nodes()), nullptr);
  for (const auto& h : grid.hanging_nodes()) hanging_of[h.node] = &h;
  std::vector<Index> unknown_of(static_cast<std::size_t>(grid.n_nodes()), no_index);
  const auto meet = [&](Index node) {
    if (unknown_of[node] != no_index) return;
    if (boundary == BoundaryCondition::dirichlet && grid.is_boundary_node(node)) return;
    unknown_of[node] = static_cast<Index>(nodes_.size());
    nodes_.push_back(node);
  };
  nodes_.reserve(grid.free_nodes().size());
  for (const Element<Dim>& element : elements_)
    for (const Index node : element.nodes) {
      if (const auto* h = hanging_of[node])
        for (int p = 0; p < h->n_parents; ++p) meet(h->parents[p]);
      else
        meet(node);
    }

  first_carrier_.reserve(hanging_of.size() + 1);
  for (Index node = 0; node < grid.n_nodes(); ++node) {
    first_carrier_.push_back(carriers_.size());
    if (const auto* h = hanging_of[node]) {
      for (int p = 0; p < h->n_parents; ++p)
        if (const Index u = unknown_of[h->parents[p]]; u != no_index)
          carriers_.push_back({u, 1.0F / static_cast<float>(h->n_parents)});
    } else if (unknown_of[node] != no_index) {
      carriers_.push_back({unknown_of[node], 1.0F});
    }
  }
  first_carrier_.push_back(carriers_.size());

  const auto for_each_place = [&](auto&& visit) {
    for (std::size_t e = 0; e < elements_.size(); ++e)
      for (int c = 0; c < n_corners<Dim>; ++c)
        for (const Carrier& carrier : carriers_of(elements_[e].nodes[c]))
          visit(carrier.unknown, Place{static_cast<Index>(e) * n_corners<Dim> + c, carrier.weight});
  };
  first_.assign(nodes_.size() + 1, 0);
  for_each_place([&](Index u, const Place&) { ++first_[u + 1]; });
  for (std::size_t i = 0; i < nodes_.size(); ++i) first_[i + 1] += first_[i];
  places_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for_each_place([&](Index u, const Place& p) { places_[next[u]++] = p; });
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
  const auto hanging = grid_->hanging_nodes();
  parallel_for(
      hanging.size(),
      [&](std::size_t i) {
        const auto& h = hanging[i];
        Vec<Dim> sum = nodal[h.parents[0]];
        for (int p = 1; p < h.n_parents; ++p) sum += nodal[h.parents[p]];
        nodal[h.node] = sum / h.n_parents;
      },
      8192);
}

template <int Dim>
void Unknowns<Dim>::restrict_to(const std::vector<Vec<Dim>>& nodal, std::span<double> x) const {
  SHELLMATCH_CHECK(x.size() == size(), "size of the unknowns");
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (int k = 0; k < Dim; ++k) x[Dim * i + k] = nodal[nodes_[i]][k];
}

template struct ShapeTable<2>;
template struct ShapeTable<3>;
template class Unknowns<2>;
template class Unknowns<3>;

}  // namespace shellmatch
