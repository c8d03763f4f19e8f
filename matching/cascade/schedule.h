#pragma once
/// \file
/// The order in which one level's minimisations lower nu (paper, section 4) and raise the volume term's weight.

#include "matching/experiment/options.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Parameters nu and c_vol of one minimisation. schedule_of_level() lists those of a level in their order.
struct ScheduleStep {
  double nu, volume_weight;
};
std::vector<ScheduleStep> schedule_of_level(const CascadeOptions& options, int level);

/// The index of the step to follow step `s`, which ended with energy `value`, of which `over_nu` is the part that is proportional to
/// 1/nu (match and coverage): s + 1, or the last. That part tells by how much the last nu raises the energy. If the rise is less
/// than the share `negligible` of the energy, the steps in between are skipped.
std::size_t step_after(const std::vector<ScheduleStep>& steps, std::size_t s, double over_nu, double value,
                       double negligible);

}  // namespace shellmatch
