#include "apps/studies/report/convergence.h"

#include <cmath>
#include <limits>

namespace shellmatch {

std::vector<ConvergencePoint> finest_convergence(const History& history, const MatchSummary& summary, int max_level) {
  ConvergencePoint before;  // cost of the earlier minimisations
  int n_substeps = 0;
  for (std::size_t i = 0; i < summary.levels.size(); ++i) {
    const LevelSummary& level = summary.levels[i];
    if (level.level == max_level) {
      n_substeps = level.n_substeps;
      continue;
    }
    before.evaluations += level.value_evaluations;
    before.gradient_evaluations += level.gradient_evaluations;
    if (i < summary.run.level_seconds.size()) before.seconds += summary.run.level_seconds[i];
  }
  std::vector<ConvergencePoint> points;
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    const HistoryRow& row = history.rows[i];
    if (row.level != max_level) continue;
    const IterationRecord& r = row.record;
    if (row.substep == n_substeps) {
      points.push_back({r.iteration, r.value, before.evaluations + r.value_evaluations,
                        before.gradient_evaluations + r.gradient_evaluations, before.seconds + r.seconds});
    } else if (i + 1 == history.rows.size() || history.rows[i + 1].substep != row.substep) {
      before.evaluations += r.value_evaluations;
      before.gradient_evaluations += r.gradient_evaluations;
      before.seconds += r.seconds;
    }
  }
  return points;
}

double relative_gap(double value, double best) {
  if (!std::isfinite(value) || !std::isfinite(best) || best == 0) return std::numeric_limits<double>::quiet_NaN();
  return (value - best) / std::abs(best);
}

std::optional<GapCost> cost_to_gap(const std::vector<ConvergencePoint>& points, double best, double gap) {
  for (const ConvergencePoint& p : points)
    if (relative_gap(p.value, best) <= gap) return GapCost{p.evaluations, p.gradient_evaluations, p.seconds};
  return std::nullopt;
}

}  // namespace shellmatch
