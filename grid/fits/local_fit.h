#pragma once
/// \file
/// Second derivatives of a nodal field by local least squares.

#include "grid/octree/nodal_values.h"
#include "grid/octree/octree.h"
#include "grid/options.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
using Hessians = std::vector<SymmetricComponents<Dim>>;

/// Least number of nodes of a neighbourhood besides its centre: options.neighbours, or the default of the
/// dimension.
template <int Dim>
std::size_t n_neighbours(const CoefficientOptions& options);

/// Hessians at the given free nodes: those of the quadratics that fit the field best, by weighted least
/// squares, at the node and its r nearest free nodes (paper, section 5). Free nodes at equal distance are all
/// included or all left out, so the result has the symmetries of the grid. A neighbourhood that does not
/// determine a quadratic well, as may occur where the level changes, is enlarged until it does. Exact for
/// quadratics. Uses options.neighbours and options.fit_weight. Returns one Hessian for each of `nodes`, in
/// their order.
/// \pre the grid's level is at least 1; `nodes` are free
template <int Dim>
Hessians<Dim> fit_hessians(const Octree<Dim>& grid, const std::vector<double>& nodal, const CoefficientOptions& options,
                           std::span<const Index> nodes);

/// The same for two fields, which share neighbourhoods and matrices, at little more than the cost of one.
template <int Dim>
std::array<Hessians<Dim>, 2> fit_hessians(const Octree<Dim>& grid, const std::array<std::vector<double>, 2>& nodal,
                                          const CoefficientOptions& options, std::span<const Index> nodes);

}  // namespace shellmatch
