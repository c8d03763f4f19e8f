#pragma once
/// \file
/// What happens when a method gives up: another one goes on from its best point.

#include "solvers/options.h"

#include <functional>
#include <string>
#include <vector>

namespace shellmatch {

/// The methods that take over, in their order, with `auto` resolved: lbfgs after newton, nothing after the others.
std::vector<std::string> fallback_names(const SolverOptions& options);

/// Did the method end without having converged, for a reason that is its own: no lower value found, or a library's
/// own rules? A gradient of a millionth of its first norm is as good as converged: what ends there ends for rounding.
bool gave_up(const MinimizerSummary& summary);

/// Minimises with options.name in options.metric, each method in the metric if it uses one. As long as the method gave
/// up, the next of fallback_names() goes on from the best point, within what is left of the limits in `stop`.
///
/// The records form one sequence: iterations, evaluations and seconds go on counting, `solver` names the method, and
/// the start of a method that takes over is the last record of the one before. The summary is of the whole;
/// `fallbacks` has one line for every change, which `announce` is given as it happens.
/// \throws InputError as make_minimizer and the methods
MinimizerSummary minimize_with_fallback(const SolverOptions& options, Objective& objective, std::vector<double>& x,
                                        const StopOptions& stop, const IterationCallback& callback = {},
                                        const std::function<void(const std::string&)>& announce = {});

}  // namespace shellmatch
