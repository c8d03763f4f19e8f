#pragma once
/// \file
/// Second derivatives at the nodes of a grid that is refined step by step: at each node from the finest lattice
/// that surrounds it.

#include "grid/fits/local_fit.h"

namespace shellmatch {

/// On the uniform grid that it begins with, and at the boundary of the domain, these are the fits of
/// grid/fits/local_fit.h. From then on a node is fitted where a refinement has put it among cells of one size; one that
/// lies where sizes change keeps what it had on the coarser lattice, or takes the multilinear mean of those that
/// had it. So neighbourhoods are never lopsided (their fits would be of first order, the lattice's are of second),
/// none has to be searched for, and only what is new is worked on.
template <int Dim>
class HierarchicalFit {
 public:
  /// To be called with the uniform grid first, and then after every refinement. \pre the field's earlier values
  /// have not changed
  void update(const Octree<Dim>& grid, const std::vector<double>& nodal, const CoefficientOptions& options);

  std::size_t size() const { return values_.size(); }
  /// At a node of the grid of the last update.
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
