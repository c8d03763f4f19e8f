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

/// How many nodes beside the one in the middle a neighbourhood has at least: r of the options, or of the space.
template <int Dim>
std::size_t n_neighbours(const CoefficientOptions& options);

/// Hessians at the given free nodes: those of the quadratics that fit the field best, in the sense of
/// weighted least squares, at the node and at its r nearest free nodes (paper, section 5). Of free nodes that
/// are equally far all are taken or none, so that the result has the symmetries of the grid. Where the
/// neighbourhood does not determine a quadratic well, as it may happen where the level changes, it is
/// enlarged until it does. Exact for quadratics. Read are options.neighbours and options.fit_weight. One
/// Hessian for each of `nodes`, in their order. \pre the grid's level is at least 1; `nodes` do not hang
template <int Dim>
Hessians<Dim> fit_hessians(const Octree<Dim>& grid, const std::vector<double>& nodal,
                           const CoefficientOptions& options, std::span<const Index> nodes);

/// The same for two fields at little more than the price of one, as they share neighbourhoods and matrices.
template <int Dim>
std::array<Hessians<Dim>, 2> fit_hessians(const Octree<Dim>& grid,
                                          const std::array<std::vector<double>, 2>& nodal,
                                          const CoefficientOptions& options, std::span<const Index> nodes);

}  // namespace shellmatch
