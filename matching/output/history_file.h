#pragma once
/// \file
/// history.csv: one line for each accepted step of the whole run.

#include "matching/result/history.h"
#include "render/canvas/plot.h"

#include <string>

namespace shellmatch {

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
