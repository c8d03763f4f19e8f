#pragma once
/// \file
/// A shape's own grid for its smooth fields: fine around the shape, as wide as splines need it, and nowhere
/// else; and distances that are kept while a grid grows.

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
  /// Exact distances are kept over refinements: a node's distance does not change, only new nodes ask. Those
  /// of fast marching improve everywhere. By either method signs are exact.
  void compute(const Octree<Dim>& grid, const SignedDistance<Dim>& shape, DistanceMethod method);

  const std::vector<double>& values() const { return values_; }
  /// Gives them away.
  std::vector<double> take() { return std::exchange(values_, {}); }

 private:
  std::vector<double> values_;
};

template <int Dim>
struct FieldGrid {
  Octree<Dim> grid;
  NodalDistance<Dim> distance;
  HierarchicalFit<Dim> hessians;  ///< of the distance

  /// Uniform; nothing is computed yet.
  explicit FieldGrid(int level) : grid(level) {}

  /// Distances and their second derivatives at the nodes. To be called at the beginning and after every
  /// refinement.
  void compute(const SignedDistance<Dim>& shape, const CoefficientOptions& options);

  /// Splits every finest cell with a corner nearer to the shape than `reach` of its sides, at least 1.
  /// \pre the distances are those of this grid
  void refine(double reach);
};

}  // namespace shellmatch
