#pragma once
/// \file
/// report.html of a cohort: one page that opens without a network (docs/cohorts.md).

#include "apps/cohorts/cohort_result.h"

#include <string>
#include <vector>

namespace shellmatch {

/// The page. Pages of subjects are links to `folder`/report.html of each, relative to the page.
template <int Dim>
std::string cohort_report_html(const CohortResult<Dim>& result);

/// Lengths are in the unit of the shapes. A list is empty where it is not defined.
struct CohortPointValues {
  std::vector<double>
      deviation;  ///< root of the sum of squared distances from the mean over n - 1, for two shapes or more
  std::vector<double> difference;  ///< length of the mean of B minus the mean of A
  std::vector<double>
      difference_normal;  ///< its component along the outward normal of the mean shape; NaN without normal
};

/// \param mean shape, with facets. They are taken to be oriented alike; outward is where the enclosed volume (area) is
/// positive.
template <int Dim>
CohortPointValues cohort_point_values(const CohortResult<Dim>& result, const Surface<Dim>& mean);

}  // namespace shellmatch
