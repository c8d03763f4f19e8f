#pragma once
/// \file
/// The files of a finished cohort (docs/cohorts.md).

#include "cohorts/cohort.h"
#include "cohorts/cohort_result.h"
#include "cohorts/execution/run_cohort.h"

#include <string>
#include <vector>

namespace shellmatch {

/// Writes tables, model and page into the cohort's folder, each file whole or not at all. All but times.csv
/// is the same to the bit for every execution in which no matching reaches a limit. \param notes takes lines
/// for the user \return the figures in a few lines \throws EnvironmentError if a file cannot be
/// written; Stopped
template <int Dim>
std::vector<std::string> write_cohort(const Cohort& cohort, FinishedCohort<Dim> finished,
                                      const std::string& folder, std::vector<std::string>& notes);

}  // namespace shellmatch
