#pragma once
/// \file
/// summary.md: a study's results for people.

#include "studies/report/study_table.h"

#include <string>

namespace shellmatch {

/// What the plots are called is settled in study_plots.h; they lie in plots/ beside the summary.
std::string study_report(const Study& study, const StudyTable& table);

}  // namespace shellmatch
