#pragma once
/// \file
/// Adaptive quadtree and octree of the unit square and cube.

#include "base/types.h"
#include "grid/octree/cell_lattice.h"
#include "grid/octree/cell_locator.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace shellmatch {

/// A node that lies on an edge or face of a coarser cell and is not a corner of that cell. Its value is the
/// mean of its `n_parents` parents, which are free nodes.
template <int Dim>
struct HangingNode {
  Index node;
  int n_parents;  ///< 2 on an edge, 4 on a face
  std::array<Index, (Dim == 2 ? 2 : 4)> parents;
};

/// A grid of square or cubic cells of side 2^-level, 2:1 balanced across faces, edges and corners, so that
/// the parents of a hanging node are free nodes. Nodes and cells are numbered consecutively, and refinement
/// keeps the numbers of existing nodes and cells (paper, section 5). New nodes and cells are numbered along a
/// Morton curve, so that neighbours are close in memory.
///
/// The children of a cell are numbered consecutively, and the data that they share are stored once: about 50
/// bytes for each node of an octree. There are no maps by level and coordinates: cells are found by
/// descending from a table at a coarse level, and a node, unless it is a corner of the domain, in a cell that
/// has it as its centre or as the midpoint of an edge or face.
template <int Dim>
class Octree {
 public:
  static constexpr int max_level = CellLocator<Dim>::max_level;
  using Coord = std::array<std::int32_t, Dim>;

  /// The numbers of a cell and of its neighbours of the same size, by offset; no_index where there is none.
  using Neighbours = std::array<Index, n_lattice<Dim>>;

  struct Cell {
    Coord corner;  ///< lower corner, in units of the cell's side
    std::int32_t level;
    Index first_child;                        ///< of 2^Dim consecutive ones; no_index for a leaf
    std::array<Index, n_corners<Dim>> nodes;  ///< corner c: bit k is the side along axis k
    bool is_leaf() const { return first_child == no_index; }
    double side() const { return 1.0 / static_cast<double>(1 << level); }
  };

  /// Uniform grid. \pre 0 <= level <= max_level
  explicit Octree(int level);

  /// Splits every leaf for which mark(leaf) holds, and those that the 2:1 balance requires. Returns the
  /// number of cells that were split. `mark` is called in parallel. \pre a leaf of max_level is not marked
  std::size_t refine(const std::function<bool(Index leaf)>& mark);

  Index n_nodes() const { return static_cast<Index>(node_coords_.size()); }
  Index n_cells() const { return locator_.n_cells(); }
  Cell cell(Index c) const;
  std::span<const Index> leaves() const { return leaves_; }  ///< in ascending order of number
  int finest_level() const { return finest_level_; }
  double finest_side() const { return 1.0 / static_cast<double>(1 << finest_level_); }

  Vec<Dim> node_position(Index node) const;
  const Coord& node_coord(Index node) const { return node_coords_[node]; }  ///< in units of 2^-max_level
  Vec<Dim> cell_corner(Index number) const;                                 ///< lower corner
  Vec<Dim> cell_centre(Index number) const;

  std::span<const HangingNode<Dim>> hanging_nodes() const { return hanging_; }  ///< ascending by node
  std::span<const Index> free_nodes() const { return free_; }                   ///< nodes that are unknowns, ascending
  /// Position in free_nodes(), or no_index for a hanging node.
  Index free_index(Index node) const { return free_index_[node]; }
  bool is_boundary_node(Index node) const;

  /// See CellLocator::locate() and find().
  Index locate(const Vec<Dim>& x) const { return locator_.locate(x); }
  Index find_cell(int level, const Coord& corner) const { return locator_.find(level, corner); }
  /// find_cell() for this cell and for all its neighbours, in one descent. \pre the cell is in the domain
  Neighbours find_neighbours(int level, const Coord& corner) const;
  /// For copies that locate points without the octree.
  const CellLocator<Dim>& locator() const { return locator_; }
  /// The node at this position, or no_index. \pre 0 <= coordinates <= 2^max_level
  Index find_node(const Coord& position_at_max_level) const;

  std::size_t memory_bytes() const;
  /// Memory of one cell in bytes, its share of its family included.
  static constexpr double bytes_per_cell();

 private:
  /// The children of one cell.
  struct Family {
    Coord corner;  ///< of the first child, in units of its side
    std::int32_t level;
    std::array<Index, n_lattice<Dim>> nodes;  ///< at the lattice points of the parent
  };
  // Family 0 has one member, the root, which is stored as if it were the last child of a cell.
  static constexpr int last_child = n_corners<Dim> - 1;
  static Index family_of(Index cell) { return (cell + last_child) >> Dim; }
  static constexpr std::size_t chunk_size = 256;  // of the parallel loops
  /// The family that created the node at a point: of the cells that share the point, the children of the one
  /// that was split first. `point` is the point's number in their parent.
  struct Origin {
    Index family;
    int point;
  };

  std::array<Index, n_corners<Dim>> find_parents(int level, const Coord& corner) const;
  void close_under_balance(std::vector<Index>& to_split, std::vector<char>& is_marked) const;
  void sort_along_morton_curve(std::vector<Index>& cells) const;
  void add_families(const std::vector<Index>& parents);
  void add_nodes(Index first_family);
  Neighbours neighbours_of_parent(Index family) const;
  Origin origin(Index family, const Neighbours& neighbours, const MiddlePoint<Dim>& m) const;
  void finish_refinement();
  std::vector<std::vector<HangingNode<Dim>>> find_hanging_nodes() const;

  std::vector<Family> families_;
  std::vector<Coord> node_coords_;  ///< in units of 2^-max_level
  std::vector<Index> leaves_;
  std::vector<HangingNode<Dim>> hanging_;
  std::vector<Index> free_, free_index_;
  int finest_level_ = 0;
  CellLocator<Dim> locator_;
};

template <int Dim>
constexpr double Octree<Dim>::bytes_per_cell() {
  return static_cast<double>(sizeof(Family)) / n_corners<Dim> + sizeof(Index);
}

template <int Dim>
inline typename Octree<Dim>::Cell Octree<Dim>::cell(Index c) const {
  const Family& family = families_[family_of(c)];
  const int place = (c + last_child) & last_child;
  Cell cell;
  for (int k = 0; k < Dim; ++k) cell.corner[k] = family.corner[k] + ((place >> k) & 1);
  cell.level = family.level;
  cell.first_child = locator_.first_child(c);
  const Index* own = family.nodes.data() + lattice_step<Dim>[place];
  for (int corner = 0; corner < n_corners<Dim>; ++corner) cell.nodes[corner] = own[lattice_step<Dim>[corner]];
  return cell;
}

template <int Dim>
inline Vec<Dim> Octree<Dim>::node_position(Index node) const {
  Vec<Dim> x;
  for (int k = 0; k < Dim; ++k) x[k] = node_coords_[node][k] * (1.0 / (1 << max_level));
  return x;
}

template <int Dim>
inline Vec<Dim> Octree<Dim>::cell_corner(Index number) const {
  const Cell c = cell(number);
  Vec<Dim> x;
  for (int k = 0; k < Dim; ++k) x[k] = c.corner[k] * c.side();
  return x;
}

template <int Dim>
inline Vec<Dim> Octree<Dim>::cell_centre(Index number) const {
  return cell_corner(number) + Vec<Dim>::Constant(0.5 * cell(number).side());
}

extern template class Octree<2>;
extern template class Octree<3>;

}  // namespace shellmatch
