#pragma once
/// \file
/// The two shapes as the grids of a cascade see them: distances, the geometry that the energies read, and
/// where to refine.

#include "energies/fields/geometry_field.h"
#include "geometry/distance/signed_distance.h"
#include "grid/fits/curvature.h"
#include "grid/octree/octree.h"
#include "matching/level/field_grid.h"
#include "matching/experiment/options.h"

#include <optional>
#include <vector>

namespace shellmatch {

/// All calls must be made with one and the same grid of phi, before and after it is refined.
template <int Dim>
class ShapeFields {
 public:
  /// All must outlive this object; the shapes lie in the unit domain.
  ShapeFields(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape,
              const ExperimentOptions& options);

  /// Distances at the nodes of the shapes' own grids, which grow with this one, or of this grid. To be called
  /// after every refinement.
  void compute_distances(const Octree<Dim>& grid);

  /// What the options' energy reads of both. Multilinear fields refer to `grid`. \pre compute_distances()
  GeometryPair<Dim> geometry(const Octree<Dim>& grid);

  /// Splits every leaf that meets the shapes (paper, section 5): the reference, or either. \pre
  /// compute_distances()
  void refine(Octree<Dim>& grid);

 private:
  bool is_smooth() const { return options_->coefficients.interpolation == FieldInterpolation::smooth; }
  void compute_distances_on(const Octree<Dim>& grid);
  GeometryPair<Dim> smooth_geometry();
  CoefficientPair<Dim> coefficients(const GridPair<Dim>& grids, std::array<NodalGeometry<Dim>, 2> geometry) const;

  std::array<const SignedDistance<Dim>*, 2> shapes_;
  const ExperimentOptions* options_;
  std::array<NodalDistance<Dim>, 2> on_grid_;         ///< of phi
  /// For smooth fields; none once the last fields have been made on them.
  std::array<std::optional<FieldGrid<Dim>>, 2> own_;
  std::optional<GeometryPair<Dim>> smooth_;           ///< of the shapes' own grids as they are
};

/// The geometry whose fields are multilinear on one grid, from their values at its nodes.
template <int Dim>
GeometryPair<Dim> multilinear_geometry(const Octree<Dim>& grid, const CoefficientFields<Dim>& reference,
                                       const CoefficientFields<Dim>& target,
                                       const ExperimentOptions& options);

/// A field's values at the nodes of a grid.
template <int Dim>
CoefficientFields<Dim> at_nodes(const GeometryField<Dim>& field, const Octree<Dim>& grid);

/// phi = id at the nodes.
template <int Dim>
std::vector<Vec<Dim>> identity_map(const Octree<Dim>& grid);

}  // namespace shellmatch
