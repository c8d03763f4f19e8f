#pragma once
/// \file
/// What to ask a cluster for.

#include "apps/cohorts/cohort.h"

namespace shellmatch {

/// Of one matching of the last stage.
struct CohortCost {
  int threads = 1;
  double seconds = 0;  ///< wall time; meant to be too much
  double memory_mb = 0;
};

/// The cohort's limits where it has some; otherwise from the size of the finest grid of the atlas matched
/// onto itself (matching/cascade/size_estimate.h), with as much again for subjects that are larger. \throws
/// InputError for an atlas that cannot be read
CohortCost estimate_cost(const Cohort& cohort);

}  // namespace shellmatch
