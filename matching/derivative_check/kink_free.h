#pragma once
/// \file
/// Where the energy is smooth. It has kinks where a quadrature point passes out of the domain, as positions
/// are projected back, and where the target's coefficients are multilinear also where one passes into another
/// cell. A difference across a kink says nothing about a derivative.

#include "energies/assembly/element_oracle.h"

#include <span>
#include <vector>

namespace shellmatch {

/// For each coordinate, how far y may move either way without leaving its cell of the target, or the domain,
/// or, if it lies outside, without coming back into it.
template <int Dim>
Vec<Dim> distance_to_cell_faces(const Octree<Dim>& grid, const Vec<Dim>& y);

/// The same where a field is smooth across cells: only the domain's boundary counts.
template <int Dim>
Vec<Dim> distance_to_kinks(const GeometryField<Dim>& field, const Vec<Dim>& y);

/// Smallest room of the element's points in the band, in any direction; infinite where there are none.
template <int Dim>
double least_distance_to_kinks(const ElementOracle<Dim>& oracle, const GeometryField<Dim>& target, std::size_t e,
                       const typename ElementOracle<Dim>::Dofs& dofs);

struct HeldPoints {
  std::size_t n_points = 0,
              n_nodes = 0;  ///< points that would have passed a face; nodes that are held for them
};

/// Sets the direction to zero at the nodes of all elements of which a point would pass a face within `reach`
/// times the direction, until none does. `direction` by the unknowns.
template <int Dim>
HeldPoints hold_at_kinks(const Unknowns<Dim>& unknowns, const ElementOracle<Dim>& oracle,
                         const GeometryField<Dim>& target, const Octree<Dim>& grid,
                         std::span<const Vec<Dim>> phi, double reach, std::vector<double>& direction);

}  // namespace shellmatch
