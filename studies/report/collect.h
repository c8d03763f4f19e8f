#pragma once
/// \file
/// The tables, plots and summary of a study, from the results that there are.

#include "studies/execution/run_study.h"

#include <vector>

namespace shellmatch {

/// Writes table.csv, convergence.csv, plots/ and summary.md into the folder; each file appears as a whole.
/// \throws EnvironmentError if nothing can be written
void collect_study(const Study& study, const std::vector<StudyRun>& runs, const StudyFolder& folder);

/// Writes a file beside its place and renames it. \throws EnvironmentError
void replace_file(const std::string& path, const std::string& contents);

}  // namespace shellmatch
