#pragma once
/// \file
/// summary.md: the results of a study for readers.

#include "apps/studies/report/study_table.h"

#include <string>

namespace shellmatch {

/// The text of the summary. It refers to the plots in plots/ by their names in study_plots.h.
std::string study_report(const Study& study, const StudyTable& table);

}  // namespace shellmatch
