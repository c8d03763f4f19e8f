#pragma once
/// \file
/// Cohorts with known answers: ellipsoids (ellipses) of which two modes are large.

#include "apps/cohorts/cohort_result.h"

#include <string>

namespace shellmatch::test {

SubjectResult unfinished_subject(const std::string& id, const std::string& status, const std::string& message = {});

struct SampleOptions {
  int n_subjects = 12;
  int n_points = 600;        ///< about as many
  bool has_failures = true;  ///< the third did not finish, the seventh does not match, of the fifth a figure is unusual
};

/// Two modes, a length and a bend, of opposite phases over the subjects, and small ones. Group "b" is longer than group
/// "a". With two subjects or more there is a model, with three there are curves, with six a difference of the groups,
/// whose corrected p is 0.01 where it is above half of its greatest length and 0.6 elsewhere.
template <int Dim>
CohortResult<Dim> sample_cohort(const SampleOptions& options = {});

}  // namespace shellmatch::test
