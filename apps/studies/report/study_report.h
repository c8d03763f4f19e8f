#pragma once
/// \file
/// summary.md: the results of a study for readers.

#include "apps/studies/description/study.h"
#include "apps/studies/execution/run_tasks.h"
#include "apps/studies/report/study_table.h"

#include <string>
#include <vector>

namespace shellmatch {

/// Writes table.csv, convergence.csv, plots/ and summary.md to the folder, each file atomically.
/// \throws EnvironmentError if nothing can be written
void collect_study(const Study& study, const std::vector<StudyRun>& runs, const RunsFolder& folder);

/// The text of the summary. It refers to the plots in plots/ by their names in study_plots.h.
std::string study_report(const Study& study, const StudyTable& table);

}  // namespace shellmatch
