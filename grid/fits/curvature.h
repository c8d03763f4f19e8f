#pragma once
/// \file
/// The coefficients of the energies at the nodes: distance, normal, and root of the classified shape operator
/// (paper, section 5, computation of the coefficients).

#include "grid/fits/classification.h"
#include "grid/fits/hierarchical_fit.h"
#include "grid/fits/local_fit.h"
#include "grid/octree/nodal_values.h"
#include "grid/octree/octree.h"
#include "grid/options.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

/// Geometric quantities of a surface at all nodes, from its distance. Hanging nodes have the mean of their
/// parents.
template <int Dim>
struct NodalGeometry {
  std::vector<double> distance;
  std::vector<Vec<Dim>> normal;                          ///< unit vectors at free nodes, zero where undefined
  std::vector<SymmetricComponents<Dim>> extended_shape;  ///< S^ext at free nodes
};

/// Normals and extended shape operators from a conforming nodal distance. Shape operators are fitted at the
/// free nodes listed in `nodes` (all free nodes if the list is empty) and are n n^T elsewhere.
template <int Dim>
NodalGeometry<Dim> nodal_geometry(const Octree<Dim>& grid, std::vector<double> nodal_distance,
                                  const CoefficientOptions& options, std::span<const Index> nodes = {});

/// The same for two surfaces at once, at little more than the cost of one.
template <int Dim>
std::array<NodalGeometry<Dim>, 2> nodal_geometry(const Octree<Dim>& grid,
                                                 std::array<std::vector<double>, 2> nodal_distances,
                                                 const CoefficientOptions& options, std::span<const Index> nodes = {});

/// The same with given second derivatives of the distance at all nodes.
template <int Dim>
NodalGeometry<Dim> nodal_geometry(const Octree<Dim>& grid, std::vector<double> nodal_distance,
                                  const CoefficientOptions& options, const HierarchicalFit<Dim>& hessians);

/// The grids of the two surfaces; both may be the same grid.
template <int Dim>
using GridPair = std::array<const Octree<Dim>*, 2>;

/// The classifier of the options on these grids. For Classification::shift, the shift is the least that makes
/// the curvatures of both surfaces non-negative, plus tau; it is the same for both surfaces.
template <int Dim>
Classifier make_classifier(const GridPair<Dim>& grids, const CoefficientOptions& options,
                           const NodalGeometry<Dim>& first, const NodalGeometry<Dim>& second);

/// The coefficient fields of the energies at all nodes, hanging ones included.
template <int Dim>
struct CoefficientFields {
  std::vector<double> distance;
  std::vector<Vec<Dim>> normal;
  std::vector<SymmetricComponents<Dim>> root;  ///< C(S)^{1/2}, C(S)^{-1/2} or S, as requested
};

template <int Dim>
CoefficientFields<Dim> classify(const Octree<Dim>& grid, NodalGeometry<Dim> geometry, const Classifier& classifier,
                                bool inverse_root);

/// The coefficients of a single surface. With Classification::shift the shift is that of this surface alone.
template <int Dim>
CoefficientFields<Dim> compute_coefficients(const Octree<Dim>& grid, std::vector<double> nodal_distance,
                                            const CoefficientOptions& options, bool inverse_root);

/// The coefficients of reference and template with a common classifier: C(S2)^{1/2} of the template, and
/// C(S1)^{-1/2} of the reference, or C(S1)^{1/2} if options.invert_at_point is set.
template <int Dim>
struct CoefficientPair {
  CoefficientFields<Dim> reference, target;
};

/// The same with a grid for each surface: geometry and results are at the nodes of that grid.
template <int Dim>
CoefficientPair<Dim> coefficient_pair(const GridPair<Dim>& grids, std::array<NodalGeometry<Dim>, 2> geometry,
                                      const CoefficientOptions& options);

/// The same with the shape operators S = P D^2 d P, their curvatures capped, in place of the roots.
template <int Dim>
CoefficientPair<Dim> shape_operator_pair(const GridPair<Dim>& grids, std::array<NodalGeometry<Dim>, 2> geometry,
                                         const CoefficientOptions& options);

}  // namespace shellmatch
