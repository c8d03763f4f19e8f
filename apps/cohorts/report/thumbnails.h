#pragma once
/// \file
/// Small pictures of the subjects of a cohort, drawn without a display.

#include "apps/cohorts/cohort_result.h"

#include <cstddef>
#include <string>
#include <vector>

namespace shellmatch {

struct SubjectThumbnails {
  std::vector<std::string>
      pictures;                ///< bytes of a PNG for each subject; empty for those not in the statistics or left out
  double scale_end = 0;        ///< of the colours: distance from the mean at their end; 0 where all have one colour
  std::size_t n_left_out = 0;  ///< subjects of the statistics that have none
};

/// The deformed atlas of each subject after Procrustes analysis, all from one camera (in one frame). Colours are
/// distances from `mean`, up to that below which 98 % of all are. \param order subjects; pictures are made of the first
/// `most` of the statistics
template <int Dim>
SubjectThumbnails subject_thumbnails(const CohortResult<Dim>& result, const Surface<Dim>& mean,
                                     const std::vector<std::size_t>& order, std::size_t most);

}  // namespace shellmatch
