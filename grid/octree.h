#pragma once
/// \file
/// Adaptive quadtree and octree of the unit square and cube.

#include "base/types.h"
#include "grid/cell_locator.h"
#include "grid/key_map.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace shellmatch {

/// A node that lies on an edge or face of a coarser cell without being its corner. Its value is the mean of
/// its `n_parents` parents, which are free nodes.
template <int Dim>
struct HangingNode {
  Index node;
  int n_parents;  ///< 2 on an edge, 4 on a face
  std::array<Index, (Dim == 2 ? 2 : 4)> parents;
};

/// A grid of square or cubic cells of side 2^-level, 2:1 balanced across faces, edges and corners, so that a
/// hanging node's parents never hang themselves. Nodes and cells are found through hash maps keyed by level
/// and integer coordinates; both are numbered linearly, and a number never changes its meaning when the grid
/// is refined (paper, section 5). What one refinement adds is numbered along a Morton curve, so that
/// neighbours are near each other in memory.
template <int Dim>
class Octree {
 public:
  static constexpr int max_level = CellLocator<Dim>::max_level;
  using Coord = std::array<std::int32_t, Dim>;

  struct Cell {
    Coord corner;  ///< lower corner, in units of the cell's side
    std::int32_t level;
    Index first_child = no_index;             ///< its 2^Dim children stand one after the other; none: a leaf
    std::array<Index, n_corners<Dim>> nodes;  ///< corner c: bit k is the side along axis k
    bool is_leaf() const { return first_child == no_index; }
    double side() const { return 1.0 / static_cast<double>(1 << level); }
  };

  /// Uniform grid. \pre 0 <= level <= max_level
  explicit Octree(int level);

  /// Splits every leaf for which mark(leaf) holds, and what balance asks for besides. Returns the number
  /// of cells that were split. `mark` is called in parallel. A leaf of max_level must not be marked.
  std::size_t refine(const std::function<bool(Index leaf)>& mark);

  Index n_nodes() const { return static_cast<Index>(node_coords_.size()); }
  Index n_cells() const { return static_cast<Index>(cells_.size()); }
  const Cell& cell(Index c) const { return cells_[c]; }
  std::span<const Index> leaves() const { return leaves_; }  ///< in ascending order of number
  int finest_level() const { return finest_level_; }
  double finest_side() const { return 1.0 / static_cast<double>(1 << finest_level_); }

  Vec<Dim> node_position(Index node) const;
  const Coord& node_coord(Index node) const { return node_coords_[node]; }  ///< in units of 2^-max_level
  Vec<Dim> cell_corner(Index cell) const;                                   ///< lower corner
  Vec<Dim> cell_centre(Index cell) const;

  std::span<const HangingNode<Dim>> hanging_nodes() const { return hanging_; }  ///< ascending by node
  std::span<const Index> free_nodes() const { return free_; }  ///< nodes that are unknowns, ascending
  /// Position in free_nodes(), or no_index for a hanging node.
  Index free_index(Index node) const { return free_index_[node]; }
  bool is_boundary_node(Index node) const;

  /// The leaf that contains x; x outside the domain is projected onto it first. A point on a face shared by
  /// leaves belongs to the upper one; not-a-number counts as 0. Constant time.
  Index locate(const Vec<Dim>& x) const { return locator_.locate(x); }
  /// To be copied where only look-ups are wanted.
  const CellLocator<Dim>& locator() const { return locator_; }
  /// The node at this place, or no_index. \pre 0 <= coordinates <= 2^max_level
  Index find_node(const Coord& position_at_max_level) const;
  /// The cell, leaf or not, or no_index where there is none, as outside the domain.
  Index find_cell(int level, const Coord& corner) const;

  std::size_t memory_bytes() const;

 private:
  static std::uint64_t node_key(const Coord& position_at_max_level);
  static std::uint64_t cell_key(int level, const Coord& corner);

  void close_under_balance(std::vector<Index>& to_split, std::vector<char>& marked) const;
  void sort_along_morton_curve(std::vector<Index>& cells) const;
  void split(Index cell);
  Index add_node(const Coord& position_at_max_level);
  void finish_refinement();
  void find_hanging_nodes();

  std::vector<Cell> cells_;
  std::vector<Coord> node_coords_;  ///< in units of 2^-max_level
  KeyMap node_index_, cell_index_;
  std::vector<Index> leaves_;
  std::vector<HangingNode<Dim>> hanging_;
  std::vector<Index> free_, free_index_;
  int finest_level_ = 0;
  CellLocator<Dim> locator_;
};

template <int Dim>
inline Vec<Dim> Octree<Dim>::node_position(Index node) const {
  Vec<Dim> x;
  for (int k = 0; k < Dim; ++k) x[k] = node_coords_[node][k] * (1.0 / (1 << max_level));
  return x;
}

template <int Dim>
inline Vec<Dim> Octree<Dim>::cell_corner(Index cell) const {
  const Cell& c = cells_[cell];
  Vec<Dim> x;
  for (int k = 0; k < Dim; ++k) x[k] = c.corner[k] * c.side();
  return x;
}

template <int Dim>
inline Vec<Dim> Octree<Dim>::cell_centre(Index cell) const {
  return cell_corner(cell) + Vec<Dim>::Constant(0.5 * cells_[cell].side());
}

extern template class Octree<2>;
extern template class Octree<3>;

}  // namespace shellmatch
