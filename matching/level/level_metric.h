#pragma once
/// \file
/// The metrics that couple nodes, for the energy of one level.

#include "matching/level/level_energy.h"

#include <Eigen/SparseCore>

namespace shellmatch {

/// Matrix of h1 or h1_band on the unknown nodes (energies/assembly/metric_matrix.h).
/// \param weights of the terms in the minimisation that the metric is for
template <int Dim>
Eigen::SparseMatrix<double> level_metric(const LevelEnergy<Dim>& level, const SolverOptions& solver,
                                         const TermValues& weights, Metric metric);

}  // namespace shellmatch
