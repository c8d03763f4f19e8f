#pragma once
/// \file
/// Weighted H1 products of deformations, as sparse matrices for the metrics of the solvers.

#include "energies/assembly/matching_energy.h"
#include "grid/octree/octree.h"

#include <Eigen/SparseCore>

namespace shellmatch {

/// Weights of (u, v) = int (mass + band_mass eta_sigma(d1)) u v + (stiffness + band_stiffness eta_sigma(d1)) Du.Dv.
struct MetricWeights {
  double mass = 1, stiffness = 0;
  double band_mass = 0, band_stiffness = 0;
};

/// Weights that resemble the energy's second derivative at the identity, where W(I + tE) is t^2 (mu |sym E|^2 +
/// lambda/2 (tr E)^2). Stiffness: its greatest second derivative 2 mu + Dim lambda for the membrane, the bending and the
/// volume term. Mass: match holds one direction of Dim with 2/nu, hence a tenth (measured) of a Dim-th of it for each
/// component; where there is no band the volume's weight times the domain's side^-2 keeps the matrix definite.
template <int Dim>
MetricWeights stiffness_of_energy(const EnergyOptions& options, const TermValues& weights);

/// The matrix of the product on the unknown nodes, in the order of unknowns.nodes(), the same for every component;
/// hanging nodes are constrained, fixed ones left out. The mass of the whole domain is lumped: without the other
/// weights the matrix is that of the metric l2. The band's parts are integrated with the energy's own points.
/// Symmetric, both triangles stored; definite for mass > 0.
template <int Dim>
Eigen::SparseMatrix<double> metric_matrix(const Octree<Dim>& grid, const Unknowns<Dim>& unknowns,
                                          const MatchingEnergy<Dim>& energy, const MetricWeights& weights);

}  // namespace shellmatch
