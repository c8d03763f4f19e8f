#include "grid/octree.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>

namespace shellmatch {

namespace {

constexpr std::size_t power(std::size_t base, int exponent) {
  std::size_t p = 1;
  while (exponent-- > 0) p *= base;
  return p;
}

// Digits 0, 1, 2 of `number` in base 3: a point of the 3^Dim lattice of a cell that is being split.
template <int Dim>
std::array<int, Dim> lattice_point(int number) {
  std::array<int, Dim> p;
  for (int k = 0; k < Dim; ++k, number /= 3) p[k] = number % 3;
  return p;
}

}  // namespace

template <int Dim>
std::uint64_t Octree<Dim>::node_key(const Coord& position) {
  std::uint64_t key = 0;  // coordinates run to 2^19 inclusive: 20 bits each
  for (int k = 0; k < Dim; ++k) key = (key << (max_level + 1)) | static_cast<std::uint64_t>(position[k]);
  return key;
}

template <int Dim>
std::uint64_t Octree<Dim>::cell_key(int level, const Coord& corner) {
  std::uint64_t key = static_cast<std::uint64_t>(level);
  for (int k = 0; k < Dim; ++k) key = (key << max_level) | static_cast<std::uint64_t>(corner[k]);
  return key;
}

template <int Dim>
Octree<Dim>::Octree(int level) {
  SHELLMATCH_CHECK(level >= 0 && level <= max_level, "level of a uniform grid out of range");
  Cell root;
  root.corner.fill(0);
  root.level = 0;
  for (int c = 0; c < n_corners<Dim>; ++c) {
    Coord position;
    for (int k = 0; k < Dim; ++k) position[k] = ((c >> k) & 1) << max_level;
    root.nodes[c] = add_node(position);
  }
  cells_.push_back(root);
  cell_index_.insert(cell_key(0, root.corner), 0);
  finish_refinement();
  for (int l = 0; l < level; ++l) refine([](Index) { return true; });
}

template <int Dim>
std::size_t Octree<Dim>::refine(const std::function<bool(Index leaf)>& mark) {
  std::vector<char> is_marked(cells_.size(), 0);
  parallel_for(
      leaves_.size(), [&](std::size_t i) { is_marked[leaves_[i]] = mark(leaves_[i]) ? 1 : 0; }, 256);
  std::vector<Index> to_split;
  for (const Index c : leaves_)
    if (is_marked[c]) to_split.push_back(c);
  if (to_split.empty()) return 0;

  close_under_balance(to_split, is_marked);
  sort_along_morton_curve(to_split);
  cells_.reserve(cells_.size() + n_corners<Dim> * to_split.size());
  cell_index_.reserve(cells_.size() + n_corners<Dim> * to_split.size());
  for (const Index c : to_split) split(c);
  finish_refinement();
  return to_split.size();
}

// A leaf may be split once all its neighbours, across corners too, are at its level or finer. As the grid is
// balanced before, a neighbour that is too coarse is one level up, and splitting it once suffices.
template <int Dim>
void Octree<Dim>::close_under_balance(std::vector<Index>& to_split, std::vector<char>& is_marked) const {
  for (std::size_t i = 0; i < to_split.size(); ++i) {  // grows while we walk along it
    const Cell& c = cells_[to_split[i]];
    SHELLMATCH_CHECK(c.level < max_level, "a cell of the finest possible level was marked for refinement");
    for (int n = 0; n < static_cast<int>(power(3, Dim)); ++n) {
      const auto step = lattice_point<Dim>(n);
      Coord neighbour;
      for (int k = 0; k < Dim; ++k) neighbour[k] = c.corner[k] + step[k] - 1;
      const bool inside = std::all_of(neighbour.begin(), neighbour.end(),
                                      [&](std::int32_t v) { return v >= 0 && v < (1 << c.level); });
      if (!inside || find_cell(c.level, neighbour) != no_index) continue;
      for (std::int32_t& v : neighbour) v >>= 1;
      const Index coarse = find_cell(c.level - 1, neighbour);
      SHELLMATCH_CHECK(coarse != no_index, "the grid has lost its 2:1 balance");
      if (is_marked[coarse]) continue;
      is_marked[coarse] = 1;
      to_split.push_back(coarse);
    }
  }
}

template <int Dim>
void Octree<Dim>::sort_along_morton_curve(std::vector<Index>& cells) const {
  std::vector<std::pair<std::uint64_t, Index>> keyed(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& c = cells_[cells[i]];
    std::uint64_t code = 0;
    for (int bit = max_level - 1; bit >= 0; --bit)
      for (int k = Dim - 1; k >= 0; --k)
        code = (code << 1) | ((static_cast<std::uint64_t>(c.corner[k]) << (max_level - c.level) >> bit) & 1u);
    keyed[i] = {code, cells[i]};
  }
  std::sort(keyed.begin(), keyed.end());
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = keyed[i].second;
}

template <int Dim>
void Octree<Dim>::split(Index cell) {
  const Cell parent = cells_[cell];
  const int half = max_level - parent.level - 1;  // binary digits of the children's side
  std::array<Index, power(3, Dim)> lattice;
  for (std::size_t n = 0; n < lattice.size(); ++n) {
    const auto p = lattice_point<Dim>(static_cast<int>(n));
    int corner = 0;
    bool is_corner = true;
    Coord position;
    for (int k = 0; k < Dim; ++k) {
      is_corner = is_corner && p[k] != 1;
      corner |= (p[k] >> 1) << k;
      position[k] = (2 * parent.corner[k] + p[k]) << half;
    }
    lattice[n] = is_corner ? parent.nodes[corner] : add_node(position);
  }

  cells_[cell].first_child = n_cells();
  for (int child = 0; child < n_corners<Dim>; ++child) {
    Cell c;
    c.level = parent.level + 1;
    for (int k = 0; k < Dim; ++k) c.corner[k] = 2 * parent.corner[k] + ((child >> k) & 1);
    for (int corner = 0; corner < n_corners<Dim>; ++corner) {
      int n = 0;
      for (int k = Dim - 1; k >= 0; --k) n = 3 * n + ((child >> k) & 1) + ((corner >> k) & 1);
      c.nodes[corner] = lattice[n];
    }
    cell_index_.insert(cell_key(c.level, c.corner), n_cells());
    cells_.push_back(c);
  }
  finest_level_ = std::max(finest_level_, static_cast<int>(parent.level) + 1);
}

template <int Dim>
Index Octree<Dim>::add_node(const Coord& position) {
  const Index node = node_index_.insert(node_key(position), n_nodes());
  if (node == n_nodes()) node_coords_.push_back(position);
  return node;
}

template <int Dim>
void Octree<Dim>::finish_refinement() {
  leaves_.clear();
  locator_.reset(n_cells(), finest_level_);
  for (Index c = 0; c < n_cells(); ++c) {
    locator_.put(c, cells_[c].level, cells_[c].corner, cells_[c].first_child);
    if (cells_[c].is_leaf()) leaves_.push_back(c);
  }
  find_hanging_nodes();
  free_.clear();
  free_index_.assign(node_coords_.size(), 0);
  for (const HangingNode<Dim>& h : hanging_) free_index_[h.node] = no_index;
  for (Index n = 0; n < n_nodes(); ++n)
    if (free_index_[n] != no_index) {
      free_index_[n] = static_cast<Index>(free_.size());
      free_.push_back(n);
    }
}

// By the 2:1 balance, what hangs on a leaf are the midpoints of its edges and the centres of its faces: the
// points of its 3^Dim lattice with one, or one to two, but not Dim middle coordinates.
template <int Dim>
void Octree<Dim>::find_hanging_nodes() {
  hanging_.clear();
  std::vector<char> found(node_coords_.size(), 0);
  for (const Index leaf : leaves_) {
    const Cell& c = cells_[leaf];
    if (c.level == finest_level_) continue;  // nothing finer can touch it
    const int half = max_level - c.level - 1;
    for (int n = 0; n < static_cast<int>(power(3, Dim)); ++n) {
      const auto p = lattice_point<Dim>(n);
      const auto n_middle = std::count(p.begin(), p.end(), 1);
      if (n_middle == 0 || n_middle == Dim) continue;
      Coord position;
      for (int k = 0; k < Dim; ++k) position[k] = (2 * c.corner[k] + p[k]) << half;
      const Index node = find_node(position);
      if (node == no_index || found[node]) continue;
      found[node] = 1;
      HangingNode<Dim> h{node, 0, {}};
      h.parents.fill(no_index);
      for (int corner = 0; corner < n_corners<Dim>; ++corner) {
        bool is_parent = h.n_parents < static_cast<int>(h.parents.size());
        for (int k = 0; k < Dim; ++k) is_parent = is_parent && (p[k] == 1 || p[k] == 2 * ((corner >> k) & 1));
        if (is_parent) h.parents[h.n_parents++] = c.nodes[corner];
      }
      hanging_.push_back(h);
    }
  }
  std::sort(hanging_.begin(), hanging_.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
}

template <int Dim>
bool Octree<Dim>::is_boundary_node(Index node) const {
  const Coord& p = node_coords_[node];
  return std::any_of(p.begin(), p.end(), [](std::int32_t v) { return v == 0 || v == (1 << max_level); });
}

template <int Dim>
Index Octree<Dim>::find_node(const Coord& position) const {
  return node_index_.find(node_key(position));
}

template <int Dim>
Index Octree<Dim>::find_cell(int level, const Coord& corner) const {
  if (level < 0 || level > finest_level_) return no_index;
  for (const std::int32_t v : corner)
    if (v < 0 || v >= (1 << level)) return no_index;
  return cell_index_.find(cell_key(level, corner));
}

template <int Dim>
std::size_t Octree<Dim>::memory_bytes() const {
  return cells_.capacity() * sizeof(Cell) + node_coords_.capacity() * sizeof(Coord) +
         node_index_.memory_bytes() + cell_index_.memory_bytes() +
         locator_.memory_bytes() + hanging_.capacity() * sizeof(HangingNode<Dim>) +
         (leaves_.capacity() + free_.capacity() + free_index_.capacity()) * sizeof(Index);
}

template class Octree<2>;
template class Octree<3>;

}  // namespace shellmatch
