#pragma once
/// \file
/// The order in which one level's minimisations lower nu (paper, section 4) and raise the volume term's weight, and
/// where each stops.

#include "matching/experiment/options.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Parameters nu and c_vol of one minimisation. schedule_of_level() lists those of a level in their order.
struct ScheduleStep {
  double nu, volume_weight;
};
std::vector<ScheduleStep> schedule_of_level(const CascadeOptions& options, int level);

/// The index of the step to follow step `s` of n: s + 1, or the last where the weights of the last step raise the
/// energy by less than `negligible`, so that the steps in between can win nothing.
std::size_t step_after(std::size_t s, std::size_t n, double rise_at_last, double negligible);

/// What follows a minimisation: another one on the same level, that of a finer level, or nothing.
enum class Followed { on_level, by_level, by_nothing };

/// The relative decrease at which a minimisation stops, given the options of its level's solver: what others begin from
/// may be worth more, or less, than the last few gains of the last one.
double relative_decrease(const CascadeOptions& options, const SolverOptions& solver, Followed followed);

}  // namespace shellmatch
