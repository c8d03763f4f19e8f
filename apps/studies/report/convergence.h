#pragma once
/// \file
/// The convergence of a run on the finest level, and the cost of coming close to the best known energy.

#include "matching/output/history_file.h"
#include "matching/output/summary.h"

#include <optional>
#include <vector>

namespace shellmatch {

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
