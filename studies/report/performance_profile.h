#pragma once
/// \file
/// Performance profiles (E. D. Dolan and J. J. More, 'Benchmarking optimization software with performance
/// profiles', Mathematical Programming 91, 2002).

#include <vector>

namespace shellmatch {

/// rho(tau), the share of problems that a solver solves within tau times the cost of the best solver for that
/// problem: a step function that is continuous from the right. share[i] holds from ratio[i] on; ratios rise
/// strictly and begin with 1.
struct PerformanceProfile {
  std::vector<double> ratio, share;

  /// rho(tau); 0 for tau < 1.
  double at(double tau) const;
};

/// One profile for each solver. \param costs costs[p][s] > 0 of solver s on problem p, infinity where it did
/// not solve it. A problem that nobody solved counts as unsolved for all. \pre every problem has as many
/// costs as the first
std::vector<PerformanceProfile> performance_profiles(const std::vector<std::vector<double>>& costs);

}  // namespace shellmatch
