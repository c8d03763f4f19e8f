#pragma once
/// \file
/// The matrices of the metrics h1 and h1_band, which couple nodes, for the energy of one level.

#include "matching/level/level_energy.h"

#include <Eigen/SparseCore>

namespace shellmatch {

/// Matrix of the metric h1 or h1_band on the unknown nodes (energies/assembly/metric_matrix.h).
/// \param weights of the terms in the minimisation that uses the metric
template <int Dim>
Eigen::SparseMatrix<double> level_metric(const LevelEnergy<Dim>& level, const SolverOptions& solver,
                                         const TermValues& weights, Metric metric);

}  // namespace shellmatch
