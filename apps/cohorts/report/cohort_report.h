#pragma once
/// \file
/// report.html of a cohort: one page that opens without a network (docs/cohorts.md).

#include "apps/cohorts/cohort_result.h"

#include <string>

namespace shellmatch {

/// The page. Pages of subjects are links to `folder`/report.html of each, relative to the page.
template <int Dim>
std::string cohort_report_html(const CohortResult<Dim>& result);

}  // namespace shellmatch
