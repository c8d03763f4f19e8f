#pragma once
/// \file
/// The description of a cohort for its page: all but the packed arrays.

#include "apps/cohorts/cohort_result.h"
#include "apps/cohorts/report/shown_shapes.h"
#include "matching/report/packed_arrays.h"
#include "matching/report/page.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// What the page needs to know besides the result and the arrays.
struct CohortFrame {
  std::vector<std::size_t> order;  ///< of the subjects on the page
  SubjectThumbnails thumbnails;
  std::string shape;             ///< what the array "mean" is: "mean", "subject" or "atlas"
  Eigen::Index n_modes = 0;      ///< that are packed
  std::optional<PageView> view;  ///< in space
};

/// As JSON that may stand within an element of a page: it has no '<'.
template <int Dim>
std::string cohort_json(const CohortResult<Dim>& result, const CohortFrame& frame,
                        const std::vector<PackedArray>& arrays);

}  // namespace shellmatch
