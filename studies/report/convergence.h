#pragma once
/// \file
/// How a run went down on the finest level, and what it cost to come near the best energy known.

#include "matching/output/history_file.h"
#include "matching/output/summary.h"

#include <optional>
#include <vector>

namespace shellmatch {

/// An accepted step of the very last minimisation of a cascade. Costs are those of the whole cascade up to
/// here: earlier minimisations have another energy, and what they cost was spent on the way to this one.
struct ConvergencePoint {
  int iteration = 0;
  double value = 0;
  long evaluations = 0;  ///< of the energy, with or without its gradient
  long gradient_evaluations = 0;
  double seconds = 0;  ///< of minimisation; reading, set-up and output are the same for every solver
};

/// The steps of the last substep of `max_level`; empty where the run did not come so far. The totals of the
/// levels below are taken from the summary, which also counts trials after the last accepted step.
std::vector<ConvergencePoint> finest_convergence(const History& history, const MatchSummary& summary,
                                                 int max_level);

/// (value - best) / |best|; NaN where best is 0 or one of them is not finite.
double relative_gap(double value, double best);

/// What it cost until the gap was at most that large for the first time.
struct GapCost {
  long evaluations = 0, gradient_evaluations = 0;
  double seconds = 0;
};
std::optional<GapCost> cost_to_gap(const std::vector<ConvergencePoint>& points, double best, double gap);

}  // namespace shellmatch
