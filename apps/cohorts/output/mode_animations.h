#pragma once
/// \file
/// Modes of a cohort as animations.

#include "apps/cohorts/cohort_result.h"

#include <string>

namespace shellmatch {

/// Writes mode_1.webp, mode_2.webp, ... of the first modes: the shape swings between so many standard
/// deviations on either side of the mean (mode_deviations), with its displacement from the mean as colour.
/// \pre result.model \throws EnvironmentError if a file cannot be written
template <int Dim>
void write_mode_animations(const CohortResult<Dim>& result, int n_modes, const std::string& folder);

}  // namespace shellmatch
