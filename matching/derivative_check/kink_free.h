#pragma once
/// \file
/// Distances to the kinks of the energy. It has a kink where a quadrature point leaves the domain, because positions
/// are projected onto it, and, for multilinear coefficients of the target, also where a point enters another cell.
/// Differences across a kink do not approximate a derivative.

#include "energies/assembly/ceres_evaluator.h"

#include <span>
#include <vector>

namespace shellmatch {

/// For each coordinate, how far y can move in either direction without leaving its cell of the target's grid; outside
/// the domain, without re-entering it.
template <int Dim>
Vec<Dim> distance_to_cell_faces(const Octree<Dim>& grid, const Vec<Dim>& y);

/// The distance to a kink of this field for each coordinate. For a smooth field only the boundary of the domain counts.
template <int Dim>
Vec<Dim> distance_to_kinks(const GeometryField<Dim>& field, const Vec<Dim>& y);

/// Smallest distance to a kink over the element's points in the band and all coordinates; infinity without such points.
template <int Dim>
double least_distance_to_kinks(const CeresEvaluator<Dim>& costs, const GeometryField<Dim>& target, std::size_t e,
                               const typename CeresEvaluator<Dim>::Dofs& dofs);

struct HeldPoints {
  std::size_t n_points = 0,
              n_nodes = 0;  ///< points that would cross a kink; nodes fixed because of them
};

/// Sets the direction to zero at the nodes of every element with a point that would cross a kink within `reach` times
/// the direction. Repeats this until there is none. \param direction by the unknowns
template <int Dim>
HeldPoints hold_at_kinks(const Unknowns<Dim>& unknowns, const CeresEvaluator<Dim>& costs,
                         const GeometryField<Dim>& target, const Octree<Dim>& grid, std::span<const Vec<Dim>> phi,
                         double reach, std::vector<double>& direction);

}  // namespace shellmatch
