#include "solvers/stop_monitor.h"

#include <fmt/core.h>

#include <cmath>

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

}  // namespace shellmatch
