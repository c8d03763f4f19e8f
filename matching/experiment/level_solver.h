#pragma once
/// \file
/// The solver of one level: solver.levels laid over the rest of the section.

#include "solvers/options.h"

namespace shellmatch {

/// The options with what `levels` says of this level set, and without `levels`.
SolverOptions solver_at_level(const SolverOptions& options, int level);

}  // namespace shellmatch
