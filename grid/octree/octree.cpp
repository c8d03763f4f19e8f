#include "grid/octree/octree.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <utility>
#include <vector>

namespace shellmatch {

template <int Dim>
Octree<Dim>::Octree(int level) {
  SHELLMATCH_CHECK(level >= 0 && level <= max_level, "level of a uniform grid out of range");
  Family root;
  root.corner.fill(-1);
  root.level = 0;
  root.nodes.fill(no_index);
  node_coords_.resize(n_corners<Dim>);
  for (int c = 0; c < n_corners<Dim>; ++c) {
    root.nodes[lattice_step<Dim>[last_child] + lattice_step<Dim>[c]] = c;
    for (int k = 0; k < Dim; ++k) node_coords_[c][k] = ((c >> k) & 1) << max_level;
  }
  families_.push_back(root);
  finish_refinement();
  for (int l = 0; l < level; ++l) refine([](Index) { return true; });
}

template <int Dim>
std::size_t Octree<Dim>::refine(const std::function<bool(Index leaf)>& mark) {
  std::vector<char> is_marked(static_cast<std::size_t>(n_cells()), 0);
  parallel_for(
      leaves_.size(), [&](std::size_t i) { is_marked[leaves_[i]] = mark(leaves_[i]) ? 1 : 0; }, chunk_size);
  std::vector<Index> to_split;
  for (const Index c : leaves_)
    if (is_marked[c]) to_split.push_back(c);
  if (to_split.empty()) return 0;

  close_under_balance(to_split, is_marked);
  sort_along_morton_curve(to_split);
  add_families(to_split);
  finish_refinement();
  return to_split.size();
}

// A leaf may be split once all its neighbours, across corners too, are at its level or finer. The grid is
// balanced before the refinement, so a neighbour that is too coarse is one level coarser, and one split of it
// suffices. The order of the leaves found here depends on the threads; the caller sorts them.
template <int Dim>
void Octree<Dim>::close_under_balance(std::vector<Index>& to_split, std::vector<char>& is_marked) const {
  for (std::size_t begin = 0; begin < to_split.size();) {
    const std::size_t n = to_split.size() - begin;
    std::vector<std::vector<Index>> found(n_chunks(n, chunk_size));
    parallel_chunks(n, chunk_size, [&](const Chunk& chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const Cell c = cell(to_split[begin + i]);
        SHELLMATCH_CHECK(c.level < max_level, "a cell of the finest possible level was marked for refinement");
        for (const Index coarse : find_parents(c.level, c.corner)) {
          if (coarse == no_index || locator_.first_child(coarse) != no_index) continue;
          if (std::atomic_ref(is_marked[coarse]).exchange(1, std::memory_order_relaxed) == 0)
            found[chunk.index].push_back(coarse);
        }
      }
    });
    begin = to_split.size();
    for (const auto& part : found) to_split.insert(to_split.end(), part.begin(), part.end());
  }
}

template <int Dim>
void Octree<Dim>::sort_along_morton_curve(std::vector<Index>& cells) const {
  std::vector<std::pair<std::uint64_t, Index>> keyed(cells.size());
  parallel_for(cells.size(), [&](std::size_t i) {
    const Cell c = cell(cells[i]);
    std::uint64_t code = 0;
    for (int bit = max_level - 1; bit >= 0; --bit)
      for (int k = Dim - 1; k >= 0; --k)
        code = (code << 1) | ((static_cast<std::uint64_t>(c.corner[k]) << (max_level - c.level) >> bit) & 1u);
    keyed[i] = {code, cells[i]};
  });
  std::sort(keyed.begin(), keyed.end());
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = keyed[i].second;
}

template <int Dim>
void Octree<Dim>::add_families(const std::vector<Index>& parents) {
  const auto n_before = static_cast<Index>(families_.size());
  families_.reserve(families_.size() + parents.size());
  for (const Index number : parents) {
    const Cell parent = cell(number);
    Family f;
    for (int k = 0; k < Dim; ++k) f.corner[k] = 2 * parent.corner[k];
    f.level = parent.level + 1;
    f.nodes.fill(no_index);
    for (int c = 0; c < n_corners<Dim>; ++c) f.nodes[2 * lattice_step<Dim>[c]] = parent.nodes[c];
    families_.push_back(f);
    finest_level_ = std::max(finest_level_, static_cast<int>(f.level));
  }
  locator_.split(parents, finest_level_);
  add_nodes(n_before);
}

template <int Dim>
bool Octree<Dim>::is_boundary_node(Index node) const {
  const Coord& p = node_coords_[node];
  return std::any_of(p.begin(), p.end(), [](std::int32_t v) { return v == 0 || v == (1 << max_level); });
}

// A position that is not a corner of the domain is the centre of a cell or the midpoint of a face or edge, on
// exactly one level. It is a node if that cell, or one of the cells that share the face or edge, was split.
template <int Dim>
Index Octree<Dim>::find_node(const Coord& position) const {
  int n_zeros = max_level, corner_of_domain = 0;
  for (int k = 0; k < Dim; ++k) {
    n_zeros = std::min(n_zeros, std::countr_zero(static_cast<std::uint32_t>(position[k])));
    corner_of_domain |= (position[k] > 0) << k;
  }
  if (n_zeros == max_level) return cell(0).nodes[corner_of_domain];
  for (int which = 0; which < n_corners<Dim>; ++which) {  // bit k: the cell below along axis k
    Coord corner;
    std::array<int, Dim> point;
    bool is_new = true;
    for (int k = 0; k < Dim; ++k) {
      const std::int32_t halves = position[k] >> n_zeros;
      const int below = (which >> k) & 1;
      is_new = is_new && !(halves & below);  // the midpoint along this axis belongs to one cell only
      corner[k] = (halves >> 1) - below;
      point[k] = halves & 1 ? 1 : 2 * below;
    }
    if (!is_new) continue;
    const Index c = find_cell(max_level - n_zeros - 1, corner);
    if (c != no_index && locator_.first_child(c) != no_index)
      return families_[family_of(locator_.first_child(c))].nodes[lattice_number<Dim>(point)];
  }
  return no_index;
}

// The 2^Dim cells, one level coarser, that contain this cell and its neighbours.
template <int Dim>
std::array<Index, n_corners<Dim>> Octree<Dim>::find_parents(int level, const Coord& corner) const {
  std::array<Index, n_corners<Dim>> parents;
  for (int c = 0; c < n_corners<Dim>; ++c) {
    Coord parent;
    for (int k = 0; k < Dim; ++k) parent[k] = ((corner[k] - 1) >> 1) + ((c >> k) & 1);
    parents[c] = find_cell(level - 1, parent);
  }
  return parents;
}

template <int Dim>
typename Octree<Dim>::Neighbours Octree<Dim>::find_neighbours(int level, const Coord& corner) const {
  Neighbours found;
  found.fill(no_index);
  if (level == 0) {
    found[n_lattice<Dim> / 2] = 0;
    return found;
  }
  auto first = find_parents(level, corner);
  for (Index& c : first)
    if (c != no_index) c = locator_.first_child(c);
  for (int n = 0; n < n_lattice<Dim>; ++n) {
    const auto step = lattice_point<Dim>(n);
    int parent = 0, child = 0;
    for (int k = 0; k < Dim; ++k) {
      const std::int32_t place = corner[k] + step[k] - 1;
      parent |= ((place >> 1) - ((corner[k] - 1) >> 1)) << k;
      child |= (place & 1) << k;
    }
    if (first[parent] != no_index) found[n] = first[parent] + child;
  }
  return found;
}

template <int Dim>
std::size_t Octree<Dim>::memory_bytes() const {
  return families_.capacity() * sizeof(Family) + node_coords_.capacity() * sizeof(Coord) +
         hanging_.capacity() * sizeof(HangingNode<Dim>) + locator_.memory_bytes() +
         (leaves_.capacity() + free_.capacity() + free_index_.capacity()) * sizeof(Index);
}

template class Octree<2>;
template class Octree<3>;

}  // namespace shellmatch
