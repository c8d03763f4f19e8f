#include "alignment/outline/elastic_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace shellmatch {

namespace {

struct CurveStep {
  std::size_t first, second;
};
constexpr std::array<CurveStep, 7> curve_steps{{{1, 1}, {1, 2}, {2, 1}, {1, 3}, {3, 1}, {2, 3}, {3, 2}}};

}  // namespace

ElasticPath elastic_path(const Eigen::MatrixXd& costs, std::size_t first, std::size_t second, double stretching,
                         double* total) {
  const auto n = static_cast<std::size_t>(costs.rows());
  std::array<double, curve_steps.size()> penalty, length;
  for (std::size_t s = 0; s < curve_steps.size(); ++s) {
    const double ratio =
        std::log(static_cast<double>(curve_steps[s].first) / static_cast<double>(curve_steps[s].second));
    length[s] = 0.5 * static_cast<double>(curve_steps[s].first + curve_steps[s].second);
    penalty[s] = stretching * ratio * ratio;
  }
  // least(i, j): cost of the best path that ends i and j samples behind the first pair.
  Eigen::MatrixXd least = Eigen::MatrixXd::Constant(n + 1, n + 1, std::numeric_limits<double>::infinity());
  Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic> step_to(n + 1, n + 1);
  least(0, 0) = 0;
  for (std::size_t j = 1; j <= n; ++j) {
    const std::size_t column = (second + j) % n;
    for (std::size_t i = 1; i <= n; ++i) {
      const double cost = costs((first + i) % n, column);
      for (std::size_t s = 0; s < curve_steps.size(); ++s) {
        const auto [a, b] = curve_steps[s];
        if (i < a || j < b) continue;
        const double sum = least(i - a, j - b) + length[s] * (cost + penalty[s]);
        if (sum >= least(i, j)) continue;
        least(i, j) = sum;
        step_to(i, j) = static_cast<std::uint8_t>(s);
      }
    }
  }
  if (total) *total = least(n, n) / static_cast<double>(n);
  ElasticPath path;
  if (!std::isfinite(least(n, n))) return path;
  for (std::size_t i = n, j = n; i > 0;) {
    path.emplace_back((first + i) % n, (second + j) % n);
    const CurveStep step = curve_steps[step_to(i, j)];
    i -= step.first;
    j -= step.second;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

ElasticPath closed_elastic_path(const Eigen::MatrixXd& costs, std::size_t first, std::size_t second, double stretching,
                                double* total) {
  const ElasticPath path = elastic_path(costs, first, second, stretching);
  if (path.empty()) return path;
  // Half a turn away from the supposed pair, where it has the least influence.
  const auto quarter = static_cast<std::ptrdiff_t>(path.size() / 4);
  const auto anchor = *std::min_element(
      path.begin() + quarter, path.end() - quarter,
      [&](const auto& a, const auto& b) { return costs(a.first, a.second) < costs(b.first, b.second); });
  return elastic_path(costs, anchor.first, anchor.second, stretching, total);
}

}  // namespace shellmatch
