#pragma once
/// \file
/// The solver options of one level: the section `solver` with the overrides of solver.levels applied.

#include "matching/experiment/level_overrides.h"
#include "solvers/solver_options.h"

namespace shellmatch {

/// The solver options for all levels, and overrides for some of them.
struct LevelwiseSolverOptions : SolverOptions {
  LevelOverrides levels;
  static void describe(auto& self, auto& visit) {
    SolverOptions::describe(self, visit);
    visit(
        "levels", self.levels,
        {.meaning = "options of this section that hold on some levels only, as {3-5: {name: lbfgs}, 6: {metric: h1}}"});
  }
};

/// The options for this level: those for all levels, changed by the entries of `levels` that contain it.
SolverOptions solver_at_level(const LevelwiseSolverOptions& options, int level);

}  // namespace shellmatch
