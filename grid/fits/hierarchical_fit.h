#pragma once
/// \file
/// Second derivatives at the nodes of a grid that is refined step by step: each from the finest uniform
/// neighbourhood of its node.

#include "grid/fits/local_fit.h"

namespace shellmatch {

/// On the initial uniform grid, and at the boundary of the domain, these are the fits of
/// grid/fits/local_fit.h. After each refinement, the nodes that are surrounded by cells of one size are
/// fitted on that lattice. A node where the cell size changes keeps its fit on the coarser lattice, or, if it
/// is new, gets the multilinear interpolant of those around it. All neighbourhoods are therefore symmetric
/// (fits on them are of second order, others of first), no neighbour search is needed, and each refinement
/// costs work for new nodes only.
template <int Dim>
class HierarchicalFit {
 public:
  /// Call with the uniform grid first, and then after every refinement.
  /// \pre the values of the field at older nodes have not changed
  void update(const Octree<Dim>& grid, const std::vector<double>& nodal, const CoefficientOptions& options);

  std::size_t size() const { return values_.size(); }
  /// The Hessian at a node of the grid of the last update().
  SymmetricComponents<Dim> operator[](Index node) const {
    SymmetricComponents<Dim> value;
    typename Components::MapType(value.data()) = values_[node];
    return value;
  }

 private:
  using Components = Eigen::Matrix<double, Dim*(Dim + 1) / 2, 1>;
  std::vector<Components> values_;
};

extern template class HierarchicalFit<2>;
extern template class HierarchicalFit<3>;

}  // namespace shellmatch
