#include "matching/cascade/schedule.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

std::vector<ScheduleStep> schedule_of_level(const CascadeOptions& o, int level) {
  const int k = level - o.min_level;
  const double volume = o.volume * std::pow(o.volume_factor, k);
  if (k == 0) return {{o.nu, volume}};
  std::vector<ScheduleStep> steps;
  for (int s = 1; s <= o.nu_substeps; ++s)
    steps.push_back({o.nu * std::pow(o.nu_factor, k - 1 + static_cast<double>(s) / o.nu_substeps), volume});
  return steps;
}

std::size_t step_after(std::size_t s, std::size_t n, double rise_at_last, double negligible) {
  return s + 1 < n && rise_at_last < negligible ? n - 1 : s + 1;
}

double relative_decrease(const CascadeOptions& o, const SolverOptions& solver, Followed followed) {
  if (followed == Followed::by_nothing) return solver.stop.relative_decrease;
  const double level_end = o.intermediate_decrease > 0 ? o.intermediate_decrease : solver.stop.relative_decrease;
  if (followed == Followed::by_level) return level_end;
  // A step of Newton's method gains much or is the last one; those of other methods gain less.
  return std::max(level_end, solver.name == "newton" ? o.substep_decrease : 0.1 * o.substep_decrease);
}

}  // namespace shellmatch
