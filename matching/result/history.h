#pragma once
/// \file
/// The accepted steps of a whole matching.

#include "solvers/minimizer.h"

#include <string>
#include <vector>

namespace shellmatch {

/// One accepted step. The substeps of a level are minimisations with decreasing nu, counted from 1.
struct HistoryRow {
  int level = 0, substep = 0;
  double nu = 0;
  IterationRecord record;
};

/// All steps; `term_names` names IterationRecord::terms.
struct History {
  std::vector<std::string> term_names;
  std::vector<HistoryRow> rows;
};

}  // namespace shellmatch
