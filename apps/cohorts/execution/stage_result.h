#pragma once
/// \file
/// What the matchings of a stage have come to.

#include "apps/cohorts/cohort.h"
#include "apps/cohorts/cohort_result.h"
#include "apps/cohorts/execution/atlas.h"
#include "apps/studies/execution/run_result.h"
#include "apps/studies/execution/run_tasks.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// A landmark of the atlas on a subject, and where the subject's own file has it.
template <int Dim>
struct CarriedLandmark {
  std::size_t subject = 0, landmark = 0;  ///< indices among the cohort's subjects and the atlas' landmarks
  Vec<Dim> carried;
  std::optional<Vec<Dim>> known;
};

/// A landmark of a subject on the atlas.
template <int Dim>
struct ReturnedLandmark {
  std::size_t subject = 0;
  std::string name;
  std::optional<Vec<Dim>> returned;  ///< none where the inverse map has no value
};

template <int Dim>
struct StageResult {
  std::vector<SubjectResult> subjects;        ///< of the whole cohort, in its order
  std::vector<std::size_t> rows;              ///< of `subjects`: those in the mean or the statistics
  PointSets points;                           ///< Atlas::points on these subjects, each in its own coordinates
  std::vector<CarriedLandmark<Dim>> carried;  ///< on all subjects that have a result
  std::vector<ReturnedLandmark<Dim>> returned;
  std::string unit;
  Space space = Space::unsaid;  ///< the frame of the subjects' coordinates, where it is one and known
};

/// Whether a matching of a round has come near enough to its subject for the mean, and to begin the next
/// matching with: at most 0.3 of the subject is not reached. On the coarse levels of rounds the verdict would
/// refuse what a finer level mends.
bool is_near(const MatchSummary& summary);

/// Reads the results of a stage. \param tasks of all subjects, in their order \param landmarks the file of
/// each subject's own; may be empty \throws InputError for a result whose files are damaged, with what to do
template <int Dim>
StageResult<Dim> read_stage(const Cohort& cohort, const Stage& stage, const RunsFolder& folder,
                            const std::vector<RunTask>& tasks, const Atlas<Dim>& atlas,
                            const std::vector<std::string>& landmarks);

}  // namespace shellmatch
