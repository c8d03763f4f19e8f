#include "matching/level/level_energy.h"

#include "energies/assembly/metric_matrix.h"

namespace shellmatch {

template <int Dim>
Eigen::SparseMatrix<double> level_metric(const LevelEnergy<Dim>& level, const SolverOptions& solver,
                                         const TermValues& weights, Metric metric) {
  const MetricWeights product = metric == Metric::weighted_h1
                                    ? stiffness_of_energy<Dim>(level.energy.terms(), weights)
                                    : MetricWeights{.stiffness = solver.h1_length * solver.h1_length};
  return metric_matrix<Dim>(level.grid, level.unknowns, level.energy, product);
}

SHELLMATCH_2D_3D(level_metric);

}  // namespace shellmatch
