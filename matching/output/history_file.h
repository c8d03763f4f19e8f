#pragma once
/// \file
/// history.csv: one line for each accepted step of a run.

#include "matching/render/canvas/plot.h"
#include "matching/result/match_result.h"

#include <string>

namespace shellmatch {

/// The columns level, substep, nu, solver, iteration, value, one for each term, gradient_norm, l2_gradient_norm, step,
/// value_evaluations, gradient_evaluations, seconds. Reading gives back the same numbers bit for bit.
std::string history_csv(const History& history);

/// \throws EnvironmentError if the file cannot be written
void write_history(const History& history, const std::string& path);

/// \throws InputError, with the number of the line, if the file is missing or not such a table
History read_history(const std::string& path);

/// Energy and its terms over the accepted steps of all levels, with marks at the beginning of each minimisation.
/// \param over_seconds plot over seconds of minimisation instead of steps
Plot energy_plot(const History& history, bool over_seconds = false);

}  // namespace shellmatch
