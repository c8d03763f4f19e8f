#include "apps/studies/report/performance_profile.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

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

}  // namespace shellmatch
