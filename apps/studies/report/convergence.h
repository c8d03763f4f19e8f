#pragma once
/// \file
/// How methods compare: the convergence of a run on the finest level, the cost of coming close to the best known
/// energy, and performance profiles.

#include "matching/output/history_file.h"
#include "matching/output/summary.h"

#include <optional>
#include <vector>

namespace shellmatch {

/// rho(tau), the share of problems that a solver solves within tau times the cost of the best solver for that problem.
/// A step function, continuous from the right: its value is share[i] from ratio[i] on. The ratios increase strictly,
/// beginning with 1. E. D. Dolan and J. J. More, 'Benchmarking optimization software with performance profiles',
/// Mathematical Programming 91, 2002.
struct PerformanceProfile {
  std::vector<double> ratio, share;

  /// rho(tau); 0 for tau < 1.
  double at(double tau) const;
};

/// One profile for each solver. \param costs costs[p][s] > 0 of solver s on problem p, infinity if it did not solve it.
/// A problem that no solver solved counts as unsolved for all. \pre every problem has the same number of costs
std::vector<PerformanceProfile> performance_profiles(const std::vector<std::vector<double>>& costs);

/// An accepted step of the last minimisation of a cascade. Costs are those of the whole cascade until this step:
/// earlier minimisations have other energies, but they are part of the way to this one.
struct ConvergencePoint {
  int iteration = 0;
  double value = 0;
  long evaluations = 0;  ///< of the energy, with or without gradient
  long gradient_evaluations = 0;
  double seconds = 0;  ///< of minimisation; reading, set-up and output do not depend on the solver
};

/// The steps of the last substep of `max_level`; empty if the run did not reach it. The totals of earlier minimisations
/// are taken from the summary, which also counts trial steps after the last accepted one.
std::vector<ConvergencePoint> finest_convergence(const History& history, const MatchSummary& summary, int max_level);

/// (value - best) / |best|; NaN if best is 0 or one of them is not finite.
double relative_gap(double value, double best);

/// The cost until the gap first fell to a given bound.
struct GapCost {
  long evaluations = 0, gradient_evaluations = 0;
  double seconds = 0;
};
std::optional<GapCost> cost_to_gap(const std::vector<ConvergencePoint>& points, double best, double gap);

}  // namespace shellmatch
