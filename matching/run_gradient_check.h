#pragma once
/// \file
/// Checks the derivatives of an experiment given by its options: the command `shellmatch check-gradient`.

#include "matching/derivative_check/check_state.h"
#include "matching/derivative_check/gradient_check.h"
#include "matching/progress/observer.h"

#include <optional>

namespace shellmatch {

struct GradientCheckRequest {
  /// Level of the grid, in the range of the cascade. If not given: the level of the state's grid if the state is a
  /// folder, else 5 in space and 7 in the plane, clamped to the cascade's range.
  std::optional<int> level;
  CheckState state;
  GradientCheckSettings settings;
};

/// Reads and places the shapes, builds the grid and the energy that the cascade has at the end of that level, and
/// checks the derivatives there. The observer's stages report the steps. \throws InputError, EnvironmentError
GradientReport run_gradient_check(const ExperimentOptions& options, const GradientCheckRequest& request,
                                  Observer& observer);

}  // namespace shellmatch
