#pragma once
/// \file
/// The tables of a study as CSV files.

#include "apps/studies/report/study_table.h"

#include <string>
#include <vector>

namespace shellmatch {

/// One line for each run; unknown values are empty. Except for study_timing_columns(), all columns are the same bit for
/// bit for every execution of the study in which no run exceeds its limits.
std::string study_csv(const StudyTable& table);

/// One line for each accepted step on the finest level.
std::string convergence_csv(const StudyTable& table);

/// The columns that differ from one execution to the next.
std::vector<std::string> study_timing_columns();

}  // namespace shellmatch
