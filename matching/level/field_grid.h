#pragma once
/// \file
/// A separate grid for the smooth fields of one shape, refined only as far around the shape as the splines need it, and
/// signed distances that are updated as a grid is refined.

#include "geometry/distance/signed_distance.h"
#include "grid/fits/hierarchical_fit.h"
#include "grid/octree/octree.h"
#include "grid/options.h"

#include <utility>
#include <vector>

namespace shellmatch {

/// Signed distances of one shape at the nodes of one grid.
template <int Dim>
class NodalDistance {
 public:
  /// Computes the distances at all nodes. Exact distances at old nodes are kept, so that only new nodes are computed;
  /// fast marching recomputes all. The signs are exact with either method.
  void compute(const Octree<Dim>& grid, const SignedDistance<Dim>& shape, DistanceMethod method);

  const std::vector<double>& values() const { return values_; }
  /// Returns the distances and releases them here.
  std::vector<double> take() { return std::exchange(values_, {}); }

 private:
  std::vector<double> values_;
};

template <int Dim>
struct FieldGrid {
  Octree<Dim> grid;
  NodalDistance<Dim> distance;
  HierarchicalFit<Dim> hessians;  ///< second derivatives of the distance

  /// A uniform grid of this level; nothing is computed yet.
  explicit FieldGrid(int level) : grid(level) {}

  /// Computes distances and their second derivatives at the nodes. Call it at the beginning and after every refinement.
  void compute(const SignedDistance<Dim>& shape, const CoefficientOptions& options);

  /// Splits every finest cell with a corner nearer to the shape than `reach` (>= 1) sides of the cell.
  /// \pre compute() has been called for this grid
  void refine(double reach);
};

}  // namespace shellmatch
