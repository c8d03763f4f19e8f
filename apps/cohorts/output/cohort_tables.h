#pragma once
/// \file
/// The tables of a cohort as CSV. Numbers are written in the shortest form that reads back exactly; unknown
/// values are empty.

#include "apps/cohorts/cohort.h"
#include "apps/cohorts/cohort_result.h"
#include "apps/cohorts/execution/stage_result.h"
#include "matching/pairs/point_formats.h"

#include <string>
#include <vector>

namespace shellmatch {

/// One line for each subject, worst first. `row` is its place in points.npy.
std::string subjects_csv(const Cohort& cohort, const std::vector<SubjectResult>& subjects,
                         const std::vector<std::size_t>& rows);
/// Seconds of each subject's matching in the last stage, which differ from one execution to the next.
std::string times_csv(const std::vector<SubjectResult>& subjects);

/// Of each subject the score on each mode.
std::string scores_csv(const ShapeModel& model, const std::vector<SubjectResult>& subjects,
                       const std::vector<std::size_t>& rows);
/// Variance, its share, compactness, generalisation and specificity by the number of modes.
std::string modes_csv(const ShapeModel& model, const std::optional<ModelCurves>& curves);

/// The atlas' landmarks on every subject, and their distances from the subject's own where these are known.
template <int Dim>
std::string landmarks_csv(const std::vector<SubjectResult>& subjects, const std::vector<NamedPoint<Dim>>& landmarks,
                          const std::vector<CarriedLandmark<Dim>>& carried);
/// The same as sets of points for other programs: all subjects that have them, in the cohort's order.
template <int Dim>
std::vector<PointSet<Dim>> landmark_sets(const std::vector<SubjectResult>& subjects,
                                         const std::vector<NamedPoint<Dim>>& landmarks,
                                         const std::vector<CarriedLandmark<Dim>>& carried);
/// The subjects' landmarks on the atlas.
template <int Dim>
std::string returned_landmarks_csv(const std::vector<SubjectResult>& subjects,
                                   const std::vector<ReturnedLandmark<Dim>>& returned);

}  // namespace shellmatch
