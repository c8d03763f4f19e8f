#pragma once
/// \file
/// The two shapes as the grids of a cascade see them: distances at the nodes, coefficients, and where to refine.

#include "geometry/signed_distance.h"
#include "grid/curvature.h"
#include "grid/octree.h"
#include "matching/options.h"

#include <vector>

namespace shellmatch {

/// Exact distances are kept over refinements: a node's distance does not change, only new nodes ask. Those of fast
/// marching improve everywhere. All calls must be made with one and the same grid, before and after it is refined.
template <int Dim>
class ShapeFields {
 public:
  /// Both must outlive this object; the shapes lie in the unit domain.
  ShapeFields(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape, DistanceMethod method)
      : shapes_{&reference, &template_shape}, method_(method) {}

  /// Distances at all nodes; by either method their signs are exact. To be called after every refinement.
  void compute_distances(const Octree<Dim>& grid);

  /// What the options' energy reads of both, from the finite element functions with these distances at the free
  /// nodes. \pre compute_distances()
  CoefficientPair<Dim> coefficients(const Octree<Dim>& grid, const ExperimentOptions& options) const;

  /// Splits every leaf that meets either shape (paper, section 5). \pre compute_distances()
  void refine(Octree<Dim>& grid) const;

 private:
  std::array<const SignedDistance<Dim>*, 2> shapes_;
  DistanceMethod method_;
  std::array<std::vector<double>, 2> distances_;
};

/// phi = id at the nodes.
template <int Dim>
std::vector<Vec<Dim>> identity_map(const Octree<Dim>& grid);

}  // namespace shellmatch
