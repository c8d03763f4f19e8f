#include "solvers/methods/fallback.h"

#include "base/error.h"
#include "solvers/metric/metric.h"
#include "solvers/minimization_run.h"

namespace shellmatch {

namespace {

constexpr double converged_share = 1e-6;  // of the initial gradient norm

/// Adds the summary of the next method to the total of those before it.
void add(const MinimizerSummary& next, MinimizerSummary& total) {
  total.solver = next.solver;
  total.reason = next.reason;
  total.message = next.message;
  total.final_value = next.final_value;
  total.final_gradient_norm = next.final_gradient_norm;
  total.iterations += next.iterations;
  total.value_evaluations += next.value_evaluations;
  total.gradient_evaluations += next.gradient_evaluations;
  total.linear_iterations += next.linear_iterations;
  total.regularised_systems += next.regularised_systems;
  total.seconds += next.seconds;
  total.library_reports.insert(total.library_reports.end(), next.library_reports.begin(), next.library_reports.end());
}

/// A step of Newton's method costs about as much as fifty of the others: with one window for all these would stop far
/// from the minimum (docs/solvers.md).
StopOptions of_method(StopOptions stop, const std::string& name) {
  if (stop.decrease_window == 0) stop.decrease_window = name == "newton" ? 1 : 50;
  return stop;
}

/// The limits less what the previous methods have used.
StopOptions remaining(StopOptions stop, const MinimizerSummary& used) {
  stop.max_iterations = std::max(0, stop.max_iterations - used.iterations);
  if (stop.max_seconds > 0) stop.max_seconds = std::max(1e-3, stop.max_seconds - used.seconds);
  return stop;
}

/// The record with the counts of `before` added.
IterationRecord continued(IterationRecord record, const std::string& solver, const MinimizerSummary& before) {
  record.solver = solver;
  record.iteration += before.iterations;
  record.value_evaluations += before.value_evaluations;
  record.gradient_evaluations += before.gradient_evaluations;
  record.seconds += before.seconds;
  return record;
}

}  // namespace

std::vector<std::string> fallback_names(const SolverOptions& options) {
  std::vector<std::string> names;
  for (const std::string& name : options.fallback) {
    if (name != "auto") names.push_back(name);
    else if (options.name == "newton") names.emplace_back("lbfgs");
  }
  return names;
}

bool gave_up(const MinimizerSummary& s) {
  if (s.reason != StopReason::no_descent && s.reason != StopReason::library) return false;
  return !(s.final_gradient_norm <= converged_share * s.initial_gradient_norm);
}

MinimizerSummary minimize_with_fallback(const SolverOptions& options, Objective& objective, std::vector<double>& x,
                                        const StopOptions& stop, const IterationCallback& callback,
                                        const std::function<void(const std::string&)>& announce) {
  std::vector<std::string> names = fallback_names(options);
  names.insert(names.begin(), options.name);
  MinimizerSummary total;
  for (std::size_t i = 0; i < names.size(); ++i) {
    SolverOptions choice = options;
    choice.name = names[i];
    const auto minimizer = make_minimizer(choice);
    const Metric metric = minimizer->uses_metric() ? options.metric : Metric::euclidean;
    const MinimizerSummary before = total;
    MinimizerSummary s = minimize_in_metric(
        *minimizer, metric, objective, x, remaining(of_method(stop, names[i]), before), [&](const IterationRecord& r) {
          if (!callback || (i > 0 && r.iteration == 0)) return true;
          return callback(continued(r, names[i], before));
        });
    s.solver = names[i];
    if (i == 0) total = s;
    else add(s, total);
    if (!gave_up(s) || i + 1 == names.size()) break;
    total.fallbacks.push_back(fmt::format("{} gave up after {} iterations ({}: {}); {} goes on", names[i], s.iterations,
                                          enum_name(s.reason), s.message, names[i + 1]));
    if (announce) announce(total.fallbacks.back());
  }
  // Its own message names what the methods before it had left of a limit.
  if (total.reason == StopReason::max_iterations || total.reason == StopReason::max_seconds)
    total.message = StopMonitor(stop).message(total.reason);
  return total;
}

}  // namespace shellmatch
