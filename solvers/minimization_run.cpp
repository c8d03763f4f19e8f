#include "solvers/minimization_run.h"

#include "base/error.h"
#include "solvers/vector_ops.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

constexpr int most_shortened = 3;  // steps in a row with little gain

}  // namespace

StopMonitor::StopMonitor(const StopOptions& options)
    : options_(options),
      start_(std::chrono::steady_clock::now()),
      decrease_(options.relative_decrease),
      window_(static_cast<std::size_t>(std::max(options.decrease_window, 1)) + 1) {}

double StopMonitor::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::optional<StopReason> StopMonitor::check(const IterationRecord& record) {
  const auto k = static_cast<std::size_t>(record.iteration);
  if (k == 0) first_gradient_norm_ = record.gradient_norm;
  window_[k % window_.size()] = record.value;

  if (record.gradient_norm <= options_.gradient_norm * first_gradient_norm_) return StopReason::gradient_norm;
  if (k + 1 >= window_.size()) {
    const double earlier = window_[(k + 1) % window_.size()];
    decrease_ = options_.relative_decrease * (record.restrained ? options_.restrained_factor : 1);
    n_small_ = earlier - record.value < decrease_ * std::abs(earlier) ? n_small_ + 1 : 0;
    // A step that is cut off, as where a cell would fold, gains little wherever the minimum is.
    if (n_small_ >= (record.shortened ? most_shortened : 1)) return StopReason::relative_decrease;
  }
  if (record.iteration >= options_.max_iterations) return StopReason::max_iterations;
  if (out_of_time()) return StopReason::max_seconds;
  return std::nullopt;
}

std::string StopMonitor::message(StopReason reason) const {
  switch (reason) {
    case StopReason::gradient_norm:
      return first_gradient_norm_ == 0
                 ? std::string("the gradient is zero at the start")
                 : fmt::format("the gradient's norm is at most {:g} of its first value", options_.gradient_norm);
    case StopReason::relative_decrease:
      return fmt::format("the value fell by less than {:g} of itself over {} iterations", decrease_,
                         window_.size() - 1);
    case StopReason::max_iterations: return fmt::format("{} iterations are done", options_.max_iterations);
    case StopReason::max_seconds: return fmt::format("the time limit of {:g} s is reached", options_.max_seconds);
    case StopReason::no_descent: return "no lower value can be found along the steepest descent";
    case StopReason::cannot_evaluate_start: return "the function cannot be evaluated at the start";
    case StopReason::interrupted: return "stopped by the caller";
    case StopReason::converged:
    case StopReason::library: break;
  }
  return "the library stopped by its own rules";
}

MinimizationRun::MinimizationRun(Objective& objective, const StopOptions& stop, const IterationCallback& callback)
    : objective_(objective), callback_(callback), monitor_(stop) {}

Evaluation MinimizationRun::evaluate(std::span<const double> x, std::span<double> gradient) {
  SHELLMATCH_CHECK(x.size() == size() && (gradient.empty() || gradient.size() == size()),
                   "point and gradient must have as many entries as there are unknowns");
  ++summary_.value_evaluations;
  if (!gradient.empty()) ++summary_.gradient_evaluations;
  Evaluation at;
  at.feasible = objective_.evaluate(x, at.value, gradient) && std::isfinite(at.value);
  if (at.feasible && !gradient.empty()) {
    at.gradient_norm = norm(gradient);
    at.l2_gradient_norm = objective_.l2_gradient_norm(gradient);
    at.feasible = std::isfinite(at.gradient_norm);
  }
  return at;
}

bool MinimizationRun::start(std::span<const double> x, std::span<double> gradient) {
  const Evaluation at = evaluate(x, gradient);
  if (!at.feasible) {
    summary_.initial_value = summary_.final_value = std::numeric_limits<double>::quiet_NaN();
    finish(StopReason::cannot_evaluate_start, explained(monitor_.message(StopReason::cannot_evaluate_start), x));
    return false;
  }
  summary_.initial_value = summary_.final_value = at.value;
  summary_.initial_gradient_norm = summary_.final_gradient_norm = at.gradient_norm;
  start_ = at;
  IterationRecord record;
  record.value = at.value;
  record.gradient_norm = at.gradient_norm;
  record.l2_gradient_norm = at.l2_gradient_norm;
  record.terms = term_values();
  const bool go_on = report(std::move(record));
  if (size() == 0 && summary_.reason == StopReason::gradient_norm) summary_.message = "there are no unknowns";
  return go_on;
}

std::string MinimizationRun::explained(std::string message, std::span<const double> x) {
  const std::string what = objective_.what_is_not_finite(x);
  return what.empty() ? message : message + ": " + what;
}

bool MinimizationRun::accept(const Evaluation& at, double step, std::vector<double> terms, bool shortened,
                             bool restrained) {
  IterationRecord record;
  record.iteration = ++summary_.iterations;
  record.value = summary_.final_value = at.value;
  record.gradient_norm = summary_.final_gradient_norm = at.gradient_norm;
  record.l2_gradient_norm = at.l2_gradient_norm;
  record.step = step;
  record.shortened = shortened;
  record.restrained = restrained;
  record.terms = std::move(terms);
  return report(std::move(record));
}

bool MinimizationRun::report(IterationRecord record) {
  record.value_evaluations = summary_.value_evaluations;
  record.gradient_evaluations = summary_.gradient_evaluations;
  record.seconds = monitor_.seconds();
  const auto reason = monitor_.check(record);
  if (callback_ && !callback_(record)) finish(StopReason::interrupted, monitor_.message(StopReason::interrupted));
  if (reason) finish(*reason);
  return !over_;
}

void MinimizationRun::finish(StopReason reason, std::string message) {
  if (over_) return;
  over_ = true;
  const bool own_failure = reason == StopReason::no_descent || reason == StopReason::library;
  if (own_failure && out_of_time()) {
    reason = StopReason::max_seconds;
    message.clear();
  }
  summary_.reason = reason;
  summary_.message = message.empty() ? monitor_.message(reason) : std::move(message);
}

void MinimizationRun::finish_without_descent(std::span<const double> infeasible) {
  if (over_) return;
  std::string message = monitor_.message(StopReason::no_descent);
  finish(StopReason::no_descent,
         infeasible.empty() || out_of_time() ? message : explained(std::move(message), infeasible));
}

MinimizerSummary MinimizationRun::summary() const {
  MinimizerSummary s = summary_;
  s.seconds = monitor_.seconds();
  return s;
}

}  // namespace shellmatch
