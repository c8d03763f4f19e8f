#pragma once
/// \file
/// The check of an experiment's derivatives from its description: what `shellmatch check-gradient` does.

#include "matching/derivative_check/check_state.h"
#include "matching/derivative_check/gradient_check.h"
#include "matching/progress/observer.h"

#include <optional>

namespace shellmatch {

struct GradientCheckRequest {
  /// Level of the grid, one of the cascade's. Without it that of the state's grid where the state is a folder, else
  /// 5 in space and 7 in the plane, or the nearest that the cascade has.
  std::optional<int> level;
  CheckState state;
  GradientCheckSettings settings;
};

/// Reads and places the shapes, builds the grid and the energy that the cascade has at the end of that level, and
/// checks there. The observer's phases are the steps on the way. \throws InputError, EnvironmentError
GradientReport run_gradient_check(const ExperimentOptions& options, const GradientCheckRequest& request,
                                  Observer& observer);

}  // namespace shellmatch
