#pragma once
/// \file
/// The coefficients of the energies at the nodes: distance, normal and root of the classified shape operator
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

/// What a surface's distance says about it, at all nodes; hanging nodes have the mean of their parents.
template <int Dim>
struct NodalGeometry {
  std::vector<double> distance;
  std::vector<Vec<Dim>> normal;  ///< unit vectors at free nodes, zero where there is none
  std::vector<SymmetricComponents<Dim>> extended_shape;  ///< S^ext at free nodes
};

/// Normals and extended shape operators from a conforming nodal distance. Shape operators are fitted at the
/// free nodes listed in `nodes` and are n n^T elsewhere; an empty list means all.
template <int Dim>
NodalGeometry<Dim> nodal_geometry(const Octree<Dim>& grid, std::vector<double> nodal_distance,
                                  const CoefficientOptions& options, std::span<const Index> nodes = {});

/// The same for two surfaces at once, at little more than the price of one.
template <int Dim>
std::array<NodalGeometry<Dim>, 2> nodal_geometry(const Octree<Dim>& grid,
                                                 std::array<std::vector<double>, 2> nodal_distances,
                                                 const CoefficientOptions& options,
                                                 std::span<const Index> nodes = {});

/// The same with second derivatives of the distance that are known at all nodes.
template <int Dim>
NodalGeometry<Dim> nodal_geometry(const Octree<Dim>& grid, std::vector<double> nodal_distance,
                                  const CoefficientOptions& options, const HierarchicalFit<Dim>& hessians);

/// The grids of two surfaces, often one and the same.
template <int Dim>
using GridPair = std::array<const Octree<Dim>*, 2>;

/// The classifier of the options on these grids. For Classification::shift it is tau above the least that makes
/// the curvatures of both surfaces positive, so that it is one and the same for both.
template <int Dim>
Classifier make_classifier(const GridPair<Dim>& grids, const CoefficientOptions& options,
                           const NodalGeometry<Dim>& first, const NodalGeometry<Dim>& second);

/// Coefficient fields as the energies read them, at all nodes, hanging ones included.
template <int Dim>
struct CoefficientFields {
  std::vector<double> distance;
  std::vector<Vec<Dim>> normal;
  std::vector<SymmetricComponents<Dim>> root;  ///< C(S)^{1/2}, or C(S)^{-1/2} or S itself if that was asked for
};

template <int Dim>
CoefficientFields<Dim> classify(const Octree<Dim>& grid, NodalGeometry<Dim> geometry,
                                const Classifier& classifier, bool inverse_root);

/// All in one for a single surface; with Classification::shift the shift is that of this surface alone.
template <int Dim>
CoefficientFields<Dim> compute_coefficients(const Octree<Dim>& grid, std::vector<double> nodal_distance,
                                            const CoefficientOptions& options, bool inverse_root);

/// The coefficients of reference and template with one classifier: C(S2)^{1/2}, and C(S1)^{-1/2}, or
/// C(S1)^{1/2} if options.invert_at_point.
template <int Dim>
struct CoefficientPair {
  CoefficientFields<Dim> reference, target;
};

/// Geometry and results are those at the nodes of each surface's grid.
template <int Dim>
CoefficientPair<Dim> coefficient_pair(const GridPair<Dim>& grids, std::array<NodalGeometry<Dim>, 2> geometry,
                                      const CoefficientOptions& options);

/// The same with the shape operators S = P D^2 d P themselves in place of roots, their curvatures capped.
template <int Dim>
CoefficientPair<Dim> shape_operator_pair(const GridPair<Dim>& grids, std::array<NodalGeometry<Dim>, 2> geometry,
                                         const CoefficientOptions& options);

}  // namespace shellmatch
