#pragma once
/// \file
/// The accepted steps of a matching.

#include "solvers/minimizer.h"

#include <string>
#include <vector>

namespace shellmatch {

/// One accepted step. `substep` counts the minimisations of a level, with decreasing nu, from 1.
struct HistoryRow {
  int level = 0, substep = 0;
  double nu = 0;
  IterationRecord record;
};

/// All steps; `term_names` are the names of IterationRecord::terms.
struct History {
  std::vector<std::string> term_names;
  std::vector<HistoryRow> rows;
};

}  // namespace shellmatch
