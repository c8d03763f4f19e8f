#include "matching/cascade/schedule.h"

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

}  // namespace shellmatch
