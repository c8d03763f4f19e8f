#pragma once
/// \file
/// The order in which subjects are looked at.

#include "apps/cohorts/cohort_result.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Positions in `subjects`: those that did not finish, then "not-matched", "look-here" and "matched"; among these the
/// greatest distance first, either way and over the diagonal (unknown ones before all), and otherwise as in the table.
std::vector<std::size_t> worst_first(const std::vector<SubjectResult>& subjects);

}  // namespace shellmatch
