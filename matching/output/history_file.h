#pragma once
/// \file
/// history.csv: one line for each accepted step of the whole run.

#include "render/canvas/plot.h"
#include "solvers/minimizer.h"

#include <string>
#include <vector>

namespace shellmatch {

/// One line. The substeps of a level are minimisations with decreasing nu, counted from 1.
struct HistoryRow {
  int level = 0, substep = 0;
  double nu = 0;
  IterationRecord record;
};

/// All lines; `term_names` names IterationRecord::terms.
struct History {
  std::vector<std::string> term_names;
  std::vector<HistoryRow> rows;
};

/// The columns level, substep, nu, solver, iteration, value, one for each term, gradient_norm, l2_gradient_norm, step,
/// value_evaluations, gradient_evaluations, seconds; numbers such that reading gives the same bits back.
std::string history_csv(const History& history);

/// \throws EnvironmentError if the file cannot be written
void write_history(const History& history, const std::string& path);

/// \throws InputError that names the line, if the file is not there or no such table
History read_history(const std::string& path);

/// Energy and its terms along the accepted steps of all levels, with marks where a minimisation begins.
/// \param over_seconds against seconds of minimisation instead of steps
Plot energy_plot(const History& history, bool over_seconds = false);

}  // namespace shellmatch
