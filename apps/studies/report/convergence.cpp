#include "apps/studies/report/convergence.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

double PerformanceProfile::at(double tau) const {
  const auto after = std::upper_bound(ratio.begin(), ratio.end(), tau);
  return after == ratio.begin() ? 0 : share[static_cast<std::size_t>(after - ratio.begin()) - 1];
}

std::vector<PerformanceProfile> performance_profiles(const std::vector<std::vector<double>>& costs) {
  if (costs.empty()) return {};
  const std::size_t n_solvers = costs.front().size();
  std::vector<std::vector<double>> ratios(n_solvers);
  for (const std::vector<double>& row : costs) {
    SHELLMATCH_CHECK(row.size() == n_solvers, "every problem has a cost for each solver");
    const double best = row.empty() ? 0 : *std::min_element(row.begin(), row.end());
    for (std::size_t s = 0; s < n_solvers; ++s) {
      SHELLMATCH_CHECK(row[s] > 0, "costs are positive");
      if (std::isfinite(row[s])) ratios[s].push_back(row[s] / best);
    }
  }
  std::vector<PerformanceProfile> profiles(n_solvers);
  for (std::size_t s = 0; s < n_solvers; ++s) {
    std::sort(ratios[s].begin(), ratios[s].end());
    PerformanceProfile& profile = profiles[s];
    profile.ratio = {1};
    profile.share = {0};
    for (std::size_t i = 0; i < ratios[s].size(); ++i) {
      const double share = static_cast<double>(i + 1) / static_cast<double>(costs.size());
      if (ratios[s][i] == profile.ratio.back()) {
        profile.share.back() = share;
      } else {
        profile.ratio.push_back(ratios[s][i]);
        profile.share.push_back(share);
      }
    }
  }
  return profiles;
}

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
