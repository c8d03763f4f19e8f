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

/// Weights that resemble the energy's second derivative at the identity. Stiffness: the largest second derivative of each
/// density that reads Dphi (2 mu + n lambda for the thin shell's), times its weight. Mass: a term of the band that reads
/// phi alone, as match, holds one direction of n, hence a tenth (measured) of an n-th of its second derivative for each
/// component; where there is no band the weight of the terms on cells times the domain's side^-2 keeps the matrix
/// definite.
template <int Dim>
MetricWeights stiffness_of_energy(const EnergyTerms<Dim>& terms, const TermValues& weights);

/// The matrix of the inner product on the unknown nodes, in the order of unknowns.nodes(), the same for every
/// component, with constraints eliminated. The mass of the whole domain is lumped: if the other weights are 0, the
/// matrix is that of the metric l2. The integrals over the band use the energy's quadrature points. The matrix is
/// symmetric, with both triangles stored, and positive definite for mass > 0.
template <int Dim>
Eigen::SparseMatrix<double> metric_matrix(const Octree<Dim>& grid, const Unknowns<Dim>& unknowns,
                                          const MatchingEnergy<Dim>& energy, const MetricWeights& weights);

}  // namespace shellmatch
