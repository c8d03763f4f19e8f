#pragma once
/// \file
/// The files of a finished cohort (docs/cohorts.md).

#include "apps/cohorts/cohort.h"
#include "apps/cohorts/cohort_result.h"
#include "apps/cohorts/execution/run_cohort.h"

#include <string>
#include <vector>

namespace shellmatch {

struct WrittenCohort {
  std::vector<std::string> figures;  ///< in a few lines
  std::string without_result;        ///< which subjects have none, and why; empty where all have one
};

/// Writes tables, model and page into the cohort's folder, each file whole or not at all. All but times.csv
/// is the same to the bit for every execution in which no matching reaches a limit. \param notes takes lines
/// for the user \throws EnvironmentError if a file cannot be written; Stopped
template <int Dim>
WrittenCohort write_cohort(const Cohort& cohort, FinishedCohort<Dim> finished, const std::string& folder,
                           std::vector<std::string>& notes);

}  // namespace shellmatch
