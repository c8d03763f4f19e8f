#pragma once
/// \file
/// The inverse of a piecewise multilinear map of the unit domain that folds nowhere.

#include "grid/inverse/box_tree.h"
#include "grid/octree/octree.h"

#include <optional>
#include <span>

namespace shellmatch {

/// Finds x with phi(x) = y. Outside the domain phi is continued by the displacement of the domain's nearest point, and
/// so is its inverse.
template <int Dim>
class InverseMap {
 public:
  /// \param phi at all nodes, hanging nodes set, finite; both must outlive this object
  InverseMap(const Octree<Dim>& grid, std::span<const Vec<Dim>> phi);

  /// The preimage of y, to rounding: in a cell by Newton's method, and by bisecting the cell where that leaves it. A
  /// map that is injective in every cell may still overlap itself far away, across a free boundary: then the preimage
  /// in the cell of least number is returned. None where y is no image of a point, and where phi is folded around it.
  std::optional<Vec<Dim>> operator()(const Vec<Dim>& y) const;

 private:
  std::optional<Vec<Dim>> outside(const Vec<Dim>& y) const;

  const Octree<Dim>* grid_;
  std::span<const Vec<Dim>> phi_;
  BoxTree<Dim> tree_;  ///< of the images of the leaves, in their order
};

}  // namespace shellmatch
