#pragma once
/// \file
/// summary.json of a cohort: its figures.

#include "apps/cohorts/cohort_result.h"
#include "apps/cohorts/execution/stage_result.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// Median, 95 % quantile and greatest of a list.
struct Spread {
  std::size_t n = 0;
  double median = 0, p95 = 0, max = 0;
};

Spread spread_of(std::vector<double> values);

struct CohortSummary {
  std::string version, title, unit;
  std::size_t n_subjects = 0, n_finished = 0, n_matched = 0, n_look_here = 0, n_not_matched = 0, n_in_model = 0;
  std::vector<AtlasRound> rounds;
  std::optional<Spread> deformed_to_subject,
      subject_to_deformed;                   ///< of the means of subjects, in the unit of the shapes
  std::optional<Spread> landmarks;           ///< distances of carried landmarks from known ones, in that unit
  std::optional<double> standard_deviation;  ///< of the cohort: the root of the total variance
  std::vector<double> compactness;           ///< by the number of modes, up to ten
  std::optional<std::string> group_a, group_b;
  std::optional<double> group_distance, group_p;  ///< of the two means, and its permutation test
  std::optional<double> differing_share;          ///< of the points, at which the corrected p is below 0.05
};

template <int Dim>
CohortSummary cohort_summary(const CohortResult<Dim>& result, const std::vector<CarriedLandmark<Dim>>& carried);

std::string cohort_summary_json(const CohortSummary& summary);

/// The same in a few lines for people.
std::vector<std::string> cohort_summary_lines(const CohortSummary& summary);

/// How many subjects have no result, and why the first of them has none; empty where all have one.
std::string without_result(const CohortSummary& summary, const std::vector<SubjectResult>& subjects);

}  // namespace shellmatch
