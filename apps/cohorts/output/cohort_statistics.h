#pragma once
/// \file
/// The statistics of a cohort whose matchings are done.

#include "apps/cohorts/cohort.h"
#include "apps/cohorts/cohort_result.h"
#include "apps/cohorts/execution/run_cohort.h"

#include <string>
#include <vector>

namespace shellmatch {

/// \param notes takes lines on what could not be computed, and why
template <int Dim>
CohortResult<Dim> cohort_statistics(const Cohort& cohort, FinishedCohort<Dim> finished,
                                    std::vector<std::string>& notes);

}  // namespace shellmatch
