#pragma once
/// \file
/// The matchings of a stage as runs of the program.

#include "apps/cohorts/cohort.h"
#include "apps/cohorts/execution/stage.h"
#include "apps/studies/execution/run_inputs.h"
#include "apps/studies/execution/run_task.h"

#include <cstddef>
#include <string>
#include <vector>

namespace shellmatch {

/// Of a cohort with a given atlas whose poses are searched: those by whose results the poses of all others are
/// predicted, the first by id, so that their order in the table says nothing. Empty where nothing is predicted.
std::vector<std::size_t> first_subjects(const Cohort& cohort);

class StageTasks {
 public:
  /// \param folder of mirrored shapes and landmarks; created when the first one is written
  StageTasks(const Cohort& cohort, std::string folder)
      : cohort_(cohort), folder_(std::move(folder)), first_(first_subjects(cohort)) {}

  /// One run for each of these subjects, named by its id. A file that cannot be read is no reason to stop:
  /// its run will say so.
  std::vector<RunTask> of(const Stage& stage, const AtlasFiles& atlas, const std::vector<std::size_t>& subjects);

  /// The shape of a subject as it is matched: its own file or the mirrored one.
  std::string source_of(const Subject& subject) const;
  /// The results of these subjects that the poses of others may be predicted from.
  std::vector<std::string> images_of(const std::vector<std::size_t>& subjects, const std::string& runs) const;
  /// Its landmarks; empty where it has none.
  std::string landmarks_of(const Subject& subject) const;

 private:
  RunTask task(const Stage& stage, const AtlasFiles& atlas, const Subject& subject);

  const Cohort& cohort_;
  std::string folder_;
  std::vector<std::size_t> first_;
  RunInputs inputs_;
};

}  // namespace shellmatch
