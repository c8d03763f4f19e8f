#pragma once
/// \file
/// Runs a cohort, stage by stage: the rounds in which the atlas is found, and the matchings of the last one.

#include "apps/cohorts/cohort.h"
#include "apps/cohorts/cohort_result.h"
#include "apps/cohorts/execution/stage.h"
#include "apps/cohorts/execution/stage_result.h"
#include "apps/studies/execution/run_tasks.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace shellmatch {

extern const RunsFolderKind cohort_folder_kind;

/// The most rounds before the last stage.
int n_rounds(const Cohort& cohort);

/// Which part of the work a process does.
struct CohortPart {
  std::vector<std::size_t> subjects;  ///< only these, of one stage; empty: all, of all stages
  std::optional<Stage>
      stage;  ///< of `subjects`, or the last one to be closed; none: the first one that is not closed, or all
  bool collect = false;  ///< match nothing: close what is complete, as far as it goes
};

class CohortObserver : public virtual TaskObserver {
 public:
  virtual void stage_started(const Stage& /*stage*/, std::size_t /*n_subjects*/) {}
  virtual void round_ended(const AtlasRound& /*round*/) {}
  virtual void note(const std::string& /*text*/) {}
};

/// A cohort whose last stage is done.
template <int Dim>
struct FinishedCohort {
  Atlas<Dim> atlas;
  StageResult<Dim> stage;
  std::vector<AtlasRound> rounds;
};

enum class CohortEnd {
  finished,  ///< with a FinishedCohort
  stopped,   ///< on request
  in_part    ///< the part is done
};

struct CohortOutcome {
  CohortEnd end = CohortEnd::in_part;
  std::variant<std::monostate, FinishedCohort<2>, FinishedCohort<3>> result = {};
};

/// What there is already is not done again; `settings` as run_tasks().
/// \throws InputError for an atlas that cannot be read, for a round of which no subject can be used, and for
/// a stage that waits for an earlier one; EnvironmentError; Stopped between matchings
CohortOutcome run_cohort(const Cohort& cohort, const RunsFolder& folder, const TaskSettings& settings,
                         const CohortPart& part, CohortObserver& observer);

}  // namespace shellmatch
