#pragma once
/// \file
/// Writes the tables, plots and summary of a study from the available results.

#include "apps/studies/execution/run_tasks.h"
#include "apps/studies/description/study.h"

#include <vector>

namespace shellmatch {

/// Writes table.csv, convergence.csv, plots/ and summary.md to the folder, each file atomically.
/// \throws EnvironmentError if nothing can be written
void collect_study(const Study& study, const std::vector<StudyRun>& runs, const RunsFolder& folder);

}  // namespace shellmatch
