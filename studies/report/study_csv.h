#pragma once
/// \file
/// A study's tables as files with comma-separated values.

#include "studies/report/study_table.h"

#include <string>
#include <vector>

namespace shellmatch {

/// One line for each run. What is not known is empty. All columns but those of study_timing_columns() are the
/// same to the bit whenever and wherever the study is run, as long as no run is ended by its limits.
std::string study_csv(const StudyTable& table);

/// One line for each accepted step on the finest level.
std::string convergence_csv(const StudyTable& table);

/// Columns that differ from one time to the next.
std::vector<std::string> study_timing_columns();

}  // namespace shellmatch
