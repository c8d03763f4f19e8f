#pragma once
/// \file
/// Minimisation by several methods: when one fails, the next continues from its best point.

#include "solvers/solver_options.h"

#include <functional>
#include <string>
#include <vector>

namespace shellmatch {

/// The methods of options.fallback in order, with `auto` resolved: lbfgs after newton, none after the others.
std::vector<std::string> fallback_names(const SolverOptions& options);

/// True if the method stopped without convergence for a reason of its own: it found no lower value, or a
/// library stopped by its own rules. A gradient norm below 1e-6 of the initial one counts as convergence,
/// because rounding then prevents further progress.
bool gave_up(const MinimizerSummary& summary);

/// Minimises with options.name in options.metric (if the method uses a metric). While gave_up() holds, the
/// next of fallback_names() continues from the best point, within the remaining limits of `stop`.
///
/// The records form one sequence: the counts of iterations, evaluations and seconds continue, `solver` names
/// the method, and the initial point of a method is the last record of the previous one. The summary is that
/// of the whole sequence; `fallbacks` has one line for every change of method, which is passed to `announce`
/// when it happens.
/// \throws InputError as make_minimizer() and the methods do
MinimizerSummary minimize_with_fallback(const SolverOptions& options, Objective& objective, std::vector<double>& x,
                                        const StopOptions& stop, const IterationCallback& callback = {},
                                        const std::function<void(const std::string&)>& announce = {});

}  // namespace shellmatch
