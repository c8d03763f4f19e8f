#pragma once
/// \file
/// The fields of both shapes during a cascade: distances, the geometry that the energies read, and the refinement at
/// the shapes.

#include "energies/fields/geometry_field.h"
#include "geometry/distance/signed_distance.h"
#include "grid/fits/curvature.h"
#include "grid/fits/hierarchical_fit.h"
#include "grid/octree/octree.h"
#include "grid/options.h"
#include "matching/experiment/options.h"

#include <optional>
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

/// A separate grid for the smooth fields of one shape, refined only as far around it as the splines need.
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

/// All calls must be given the same grid of phi, before and after its refinements.
template <int Dim>
class ShapeFields {
 public:
  /// All arguments must outlive this object. \pre the shapes lie in the unit domain
  ShapeFields(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape,
              const ExperimentOptions& options);

  /// Computes distances at the nodes of the shapes' own grids, which are refined together with `grid`, or of `grid`
  /// itself. Call it after every refinement.
  void compute_distances(const Octree<Dim>& grid);

  /// About how many nodes compute_distances(grid) will add to the shapes' own grids; 0 without such grids.
  double n_new_field_nodes(const Octree<Dim>& grid) const;

  /// The geometry of both shapes as the options ask for. Multilinear fields refer to `grid`. \pre compute_distances()
  GeometryPair<Dim> geometry(const Octree<Dim>& grid);

  /// Splits every leaf that meets the reference, or either shape if the options say so (paper, section 5). \pre
  /// compute_distances()
  void refine(Octree<Dim>& grid);

 private:
  bool is_smooth() const { return options_->coefficients.interpolation == FieldInterpolation::smooth; }
  void compute_distances_on(const Octree<Dim>& grid);
  /// The finest level of the shapes' own grids for this grid of phi.
  int field_level(const Octree<Dim>& grid) const;
  GeometryPair<Dim> smooth_geometry();
  CoefficientPair<Dim> coefficients(const GridPair<Dim>& grids, std::array<NodalGeometry<Dim>, 2> geometry) const;

  std::array<const SignedDistance<Dim>*, 2> shapes_;
  const ExperimentOptions* options_;
  std::array<NodalDistance<Dim>, 2> on_grid_;  ///< at the nodes of phi's grid
  /// The shapes' own grids, for smooth fields; released once the fields of the finest level have been made.
  std::array<std::optional<FieldGrid<Dim>>, 2> own_;
  std::optional<GeometryPair<Dim>> smooth_;  ///< of the present state of the shapes' own grids
  std::vector<double> n_field_nodes_{0};     ///< of the states of the own grids, from coarse to fine
};

/// Multilinear geometry on one grid, from the fields at its nodes.
template <int Dim>
GeometryPair<Dim> multilinear_geometry(const Octree<Dim>& grid, const CoefficientFields<Dim>& reference,
                                       const CoefficientFields<Dim>& target, const ExperimentOptions& options);

/// The values of a field at the nodes of a grid.
template <int Dim>
CoefficientFields<Dim> at_nodes(const GeometryField<Dim>& field, const Octree<Dim>& grid);

/// The identity: phi = x at the nodes.
template <int Dim>
std::vector<Vec<Dim>> identity_map(const Octree<Dim>& grid);

}  // namespace shellmatch
