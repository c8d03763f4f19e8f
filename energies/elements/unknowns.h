#pragma once
/// \file
/// The unknowns of a grid, and the constraints that express its nodes by them.

#include "base/options.h"
#include "energies/elements/shape_table.h"
#include "grid/octree/octree.h"

#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace shellmatch {

/// At the domain's boundary: natural, or phi = id.
enum class BoundaryCondition { neumann, dirichlet };
template <>
struct EnumNames<BoundaryCondition> {
  static constexpr std::pair<BoundaryCondition, std::string_view> names[] = {
      {BoundaryCondition::neumann, "neumann"}, {BoundaryCondition::dirichlet, "dirichlet"}};
};

/// One entry of the constraint matrix C, x_node = sum of weight * x_unknown (deal.II: AffineConstraints).
struct ConstraintEntry {
  Index unknown;  ///< index of an unknown node
  float weight;   ///< 1, or 1/2 or 1/4 through a hanging node: exact in single precision
};

/// The unknowns of a grid: Dim components for each node that neither hangs nor is fixed by the boundary condition.
/// Unknown Dim*i + k is component k of node nodes()[i]. constraint_entries() is the one description of how the nodes
/// of the elements depend on the unknowns; ElementUnknowns, CellBlocks, the pattern of NodeMatrix and the constraint
/// matrix of the metrics are made from it.
template <int Dim>
class Unknowns {
 public:
  /// The grid must outlive this object and must not be refined meanwhile.
  Unknowns(const Octree<Dim>& grid, BoundaryCondition boundary);

  std::size_t size() const { return nodes_.size() * Dim; }
  /// Node of each unknown node, numbered in the order in which the elements meet them, through hanging nodes too.
  std::span<const Index> nodes() const { return nodes_; }
  std::span<const Element<Dim>> elements() const { return elements_; }  ///< in the order of grid.leaves()

  /// Row of C that belongs to a node of the grid: itself, with weight 1, for an unknown node, its parents for a hanging
  /// one (the unknown ones among them), empty for a fixed one.
  std::span<const ConstraintEntry> constraint_entries(Index node) const {
    return {entries_.data() + entries_begin_[node], entries_begin_[node + 1] - entries_begin_[node]};
  }

  /// Writes x into the nodal field and interpolates hanging nodes. Fixed nodes keep their values, which enter the
  /// hanging ones too: nodal = C x + the values of fixed parents.
  /// \pre x.size() == size(), nodal.size() == grid.n_nodes()
  void expand(std::span<const double> x, std::vector<Vec<Dim>>& nodal) const;

  /// x = the values of the nodal field at the unknown nodes. \pre sizes as for expand()
  void restrict_to(const std::vector<Vec<Dim>>& nodal, std::span<double> x) const;

 private:
  const Octree<Dim>* grid_;
  std::vector<Index> nodes_;
  std::vector<Element<Dim>> elements_;
  std::vector<std::size_t> entries_begin_;  ///< entries of a node: [entries_begin_[node], entries_begin_[node + 1])
  std::vector<ConstraintEntry> entries_;
};

}  // namespace shellmatch
