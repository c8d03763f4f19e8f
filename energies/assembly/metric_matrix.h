#pragma once
/// \file
/// Sparse matrices of weighted H1 inner products, for the metrics of the solvers.

#include "energies/assembly/matching_energy.h"
#include "grid/octree/octree.h"

#include <Eigen/SparseCore>

namespace shellmatch {

/// Weights of the inner product (u, v) = int (mass + band_mass eta_sigma(d1)) u v + (stiffness + band_stiffness
/// eta_sigma(d1)) Du.Dv.
struct MetricWeights {
  double mass = 1, stiffness = 0;
  double band_mass = 0, band_stiffness = 0;
};

/// Weights that approximate the energy's second derivative at the identity. Stiffness: for each density that reads Dphi
/// its largest second derivative (2 mu + n lambda for the thin shell's), times the term's weight. Mass: a band term
/// that reads phi alone, such as match, constrains one of n directions, hence a tenth (measured) of 1/n of its second
/// derivative for each component. Outside of the band a mass of (weight of the cell terms) / side^2, with the domain's
/// side, keeps the matrix definite.
template <int Dim>
MetricWeights stiffness_of_energy(const EnergyTerms<Dim>& terms, const TermValues& weights);

/// The matrix of the inner product on the unknown nodes, in the order of unknowns.nodes(), with constraints eliminated;
/// it is the same for every component. The mass of the whole domain is lumped: with all other weights 0 the matrix is
/// that of the metric l2. Integrals over the band use the energy's quadrature points. The matrix is symmetric, stored
/// with both triangles, and positive definite for mass > 0.
template <int Dim>
Eigen::SparseMatrix<double> metric_matrix(const Octree<Dim>& grid, const Unknowns<Dim>& unknowns,
                                          const MatchingEnergy<Dim>& energy, const MetricWeights& weights);

}  // namespace shellmatch
