#pragma once
/// \file
/// Performance profiles (E. D. Dolan and J. J. More, 'Benchmarking optimization software with performance
/// profiles', Mathematical Programming 91, 2002).

#include <vector>

namespace shellmatch {

/// rho(tau), the share of problems that a solver solves within tau times the cost of the best solver for that problem.
/// A step function, continuous from the right: its value is share[i] from ratio[i] on. The ratios increase strictly,
/// beginning with 1.
struct PerformanceProfile {
  std::vector<double> ratio, share;

  /// rho(tau); 0 for tau < 1.
  double at(double tau) const;
};

/// One profile for each solver. \param costs costs[p][s] > 0 of solver s on problem p, infinity if it did not solve it.
/// A problem that no solver solved counts as unsolved for all. \pre every problem has the same number of costs
std::vector<PerformanceProfile> performance_profiles(const std::vector<std::vector<double>>& costs);

}  // namespace shellmatch
