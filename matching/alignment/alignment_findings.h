#pragma once
/// \file
/// What the parts of an alignment that take long have found, so that a run that was stopped need not find it again.

#include "matching/alignment/choose_start.h"
#include "matching/alignment/kept_results.h"
#include "matching/alignment/trial.h"
#include "matching/prediction/reference_images.h"

#include <cstddef>

namespace shellmatch {

/// Of one pair of shapes and one experiment. All else of an alignment is computed again, in a fraction of the time.
template <int Dim>
struct AlignmentFindings {
  KeptResults<StartSearch<Dim>> by_pairs, by_poses;  ///< without fits_far_better_mirrored
  KeptResults<bool> fits_mirrored;
  TrialFindings trials;
  ReferenceImages<Dim> images = {};  ///< what earlier matchings of the same reference have found

  double seconds() const {
    return by_pairs.seconds + by_poses.seconds + fits_mirrored.seconds + trials.starts.seconds +
           trials.directions.seconds;
  }
  std::size_t size() const {
    return by_pairs.results.size() + by_poses.results.size() + fits_mirrored.results.size() +
           trials.starts.results.size() + trials.directions.results.size();
  }
};

}  // namespace shellmatch
