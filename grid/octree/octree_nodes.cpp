// The nodes of an octree: their numbers, and those that hang.
#include "base/parallel.h"
#include "grid/octree/octree.h"

#include <utility>
#include <vector>

namespace shellmatch {

namespace {

// resize() without the spare capacity that it allocates by itself.
template <class T>
void resize_exactly(std::vector<T>& v, std::size_t n) {
  v.reserve(n);
  v.resize(n);
}

}  // namespace

template <int Dim>
typename Octree<Dim>::Neighbours Octree<Dim>::neighbours_of_parent(Index family) const {
  Coord corner = families_[family].corner;
  for (std::int32_t& v : corner) v >>= 1;
  return find_neighbours(families_[family].level - 1, corner);
}

template <int Dim>
typename Octree<Dim>::Origin Octree<Dim>::origin(Index family, const Neighbours& neighbours,
                                                 const MiddlePoint<Dim>& m) const {
  Origin first{family, m.point};
  for (int i = 0; i < m.n_elsewhere; ++i) {
    const Index neighbour = neighbours[m.elsewhere[i].neighbour];
    if (neighbour == no_index || locator_.first_child(neighbour) == no_index) continue;
    const Index there = family_of(locator_.first_child(neighbour));
    if (there < first.family) first = {there, m.elsewhere[i].point};
  }
  return first;
}

// New nodes are numbered by their families of origin, and within a family by their lattice points.
template <int Dim>
void Octree<Dim>::add_nodes(Index first_family) {
  const std::size_t n = families_.size() - static_cast<std::size_t>(first_family);
  std::vector<Index> next(n_chunks(n, chunk_size));
  constexpr Index to_be_numbered = 0;  // as a mark: node 0, a corner of the domain, is never a midpoint
  parallel_chunks(n, chunk_size, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Index family = first_family + static_cast<Index>(i);
      const Neighbours neighbours = neighbours_of_parent(family);
      for (const MiddlePoint<Dim>& m : middle_points<Dim>) {
        if (origin(family, neighbours, m).family != family) continue;
        families_[family].nodes[m.point] = to_be_numbered;
        ++next[chunk.index];
      }
    }
  });
  Index n_all = n_nodes();
  for (Index& number : next) number = std::exchange(n_all, n_all + number);
  resize_exactly(node_coords_, static_cast<std::size_t>(n_all));
  parallel_chunks(n, chunk_size, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      Family& family = families_[static_cast<std::size_t>(first_family) + i];
      for (const MiddlePoint<Dim>& m : middle_points<Dim>) {
        Index& node = family.nodes[m.point];
        if (node != to_be_numbered) continue;
        node = next[chunk.index]++;
        const auto p = lattice_point<Dim>(m.point);
        for (int k = 0; k < Dim; ++k) node_coords_[node][k] = (family.corner[k] + p[k]) << (max_level - family.level);
      }
    }
  });
  parallel_for(
      n,
      [&](std::size_t i) {
        const Index family = first_family + static_cast<Index>(i);
        const Neighbours neighbours = neighbours_of_parent(family);
        for (const MiddlePoint<Dim>& m : middle_points<Dim>) {
          const Origin o = origin(family, neighbours, m);
          if (o.family != family) families_[family].nodes[m.point] = families_[o.family].nodes[o.point];
        }
      },
      chunk_size);
}

template <int Dim>
void Octree<Dim>::finish_refinement() {
  leaves_.clear();
  leaves_.reserve(static_cast<std::size_t>(n_cells()) - (families_.size() - 1));
  for (Index c = 0; c < n_cells(); ++c)
    if (locator_.first_child(c) == no_index) leaves_.push_back(c);

  const auto hanging = find_hanging_nodes();
  std::size_t n_hanging = 0;
  free_index_.assign(node_coords_.size(), 0);
  for (const auto& part : hanging) {
    n_hanging += part.size();
    for (const HangingNode<Dim>& h : part) free_index_[h.node] = no_index;
  }
  free_.clear();
  free_.reserve(node_coords_.size() - n_hanging);
  Index rank = 0;  // of a hanging node, stored as no_index - 1 - rank until hanging_ is filled
  for (Index node = 0; node < n_nodes(); ++node) {
    if (free_index_[node] == no_index) {
      free_index_[node] = no_index - 1 - rank++;
    } else {
      free_index_[node] = static_cast<Index>(free_.size());
      free_.push_back(node);
    }
  }
  hanging_.clear();
  resize_exactly(hanging_, n_hanging);
  for (const auto& part : hanging)
    for (const HangingNode<Dim>& h : part) hanging_[no_index - 1 - std::exchange(free_index_[h.node], no_index)] = h;
}

// By the 2:1 balance, a node that hangs on a leaf is the midpoint of one of its edges or faces, created by
// the split of a neighbour. Each hanging node is found once, in its family of origin.
template <int Dim>
std::vector<std::vector<HangingNode<Dim>>> Octree<Dim>::find_hanging_nodes() const {
  const std::size_t n = families_.size() - 1;
  std::vector<std::vector<HangingNode<Dim>>> found(n_chunks(n, chunk_size));
  parallel_chunks(n, chunk_size, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const auto family = static_cast<Index>(i + 1);
      const auto& nodes = families_[family].nodes;
      const Neighbours neighbours = neighbours_of_parent(family);
      for (const MiddlePoint<Dim>& m : middle_points<Dim>) {
        bool hangs = false;
        for (int e = 0; e < m.n_elsewhere; ++e) {
          const Index neighbour = neighbours[m.elsewhere[e].neighbour];
          hangs = hangs || (neighbour != no_index && locator_.first_child(neighbour) == no_index);
        }
        if (!hangs || origin(family, neighbours, m).family != family) continue;
        HangingNode<Dim> h{nodes[m.point], m.n_ends, {}};
        h.parents.fill(no_index);
        for (int e = 0; e < m.n_ends; ++e) h.parents[e] = nodes[2 * lattice_step<Dim>[m.ends[e]]];
        found[chunk.index].push_back(h);
      }
    }
  });
  return found;
}

template Octree<2>::Neighbours Octree<2>::neighbours_of_parent(Index) const;
template Octree<2>::Origin Octree<2>::origin(Index, const Neighbours&, const MiddlePoint<2>&) const;
template void Octree<2>::add_nodes(Index);
template void Octree<2>::finish_refinement();
template std::vector<std::vector<HangingNode<2>>> Octree<2>::find_hanging_nodes() const;
template Octree<3>::Neighbours Octree<3>::neighbours_of_parent(Index) const;
template Octree<3>::Origin Octree<3>::origin(Index, const Neighbours&, const MiddlePoint<3>&) const;
template void Octree<3>::add_nodes(Index);
template void Octree<3>::finish_refinement();
template std::vector<std::vector<HangingNode<3>>> Octree<3>::find_hanging_nodes() const;

}  // namespace shellmatch
