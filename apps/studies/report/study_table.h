#pragma once
/// \file
/// The results of a study as a table with one row for each run.

#include "apps/studies/report/convergence.h"
#include "apps/studies/execution/run_tasks.h"
#include "apps/studies/description/study.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// Relative gaps to the best known energy for which costs are stated.
inline constexpr std::array<double, 3> study_gaps = {1e-1, 1e-2, 1e-3};

struct StudyRow {
  StudyRun run;
  RunResult result;
  std::string instance;  ///< problem, with the parameters that change the minimised function
  std::string method;    ///< solver, metric and all other parameters
  std::optional<MatchSummary> summary;
  std::vector<ConvergencePoint> finest;  ///< steps of the last minimisation; empty if it was not reached
  double energy = 0;  ///< at the end of the finest level, with the quadrature that was minimised; else NaN
  double best = 0;    ///< least energy of all runs that minimise the same function; NaN without one
  std::array<std::optional<GapCost>, study_gaps.size()> to_gap;
};

struct StudyTable {
  std::vector<std::string> parameters;  ///< keys of the study's parameters
  std::vector<StudyRow> rows;
};

/// Reads the available results; runs without a result have a row, too, and so have those whose output is damaged, as
/// failed ones.
StudyTable make_study_table(const Study& study, const std::vector<StudyRun>& runs, const RunsFolder& folder);

}  // namespace shellmatch
