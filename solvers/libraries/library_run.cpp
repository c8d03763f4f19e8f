#include "solvers/libraries/library_run.h"

#include "solvers/vector_ops.h"

#include <algorithm>
#include <utility>

namespace shellmatch {

LibraryRun::LibraryRun(Objective& objective, const std::vector<double>& x, const StopOptions& stop,
                       const IterationCallback& callback)
    : run_(objective, stop, callback), best_x_(x), best_gradient_(x.size()), recorded_x_(x) {}

bool LibraryRun::start() {
  if (!run_.start(best_x_, best_gradient_)) return false;
  best_ = run_.start_evaluation();
  return true;
}

Evaluation LibraryRun::evaluate(std::span<const double> x, std::span<double> gradient) noexcept {
  if (halted()) return {};
  try {
    ++stalled_;
    const bool again = std::equal(x.begin(), x.end(), best_x_.begin());
    if (again && (gradient.empty() || best_has_gradient_)) {
      std::copy_n(best_gradient_.begin(), gradient.size(), gradient.begin());
      return best_;
    }
    const Evaluation at = run_.evaluate(x, gradient);
    const bool lower = at.feasible && at.value < best_.value;
    if (lower || (again && at.feasible)) keep(x, gradient, at);
    if (lower) stalled_ = 0;
    return at;
  } catch (...) {
    exception_ = std::current_exception();
    return {};
  }
}

void LibraryRun::keep(std::span<const double> x, std::span<const double> gradient, const Evaluation& at) {
  std::copy(x.begin(), x.end(), best_x_.begin());
  std::copy(gradient.begin(), gradient.end(), best_gradient_.begin());
  best_has_gradient_ = !gradient.empty();
  best_ = at;
  best_terms_ = run_.term_values();
  recorded_ = false;
}

bool LibraryRun::accept_best() noexcept {
  try {
    if (!exception_ && !recorded_ && !run_.over()) {
      if (!best_has_gradient_) {
        best_ = run_.evaluate(best_x_, best_gradient_);
        best_has_gradient_ = true;
      }
      recorded_ = true;
      const double step = distance(best_x_, recorded_x_);
      recorded_x_ = best_x_;
      run_.accept(best_, step, best_terms_);
    }
  } catch (...) {
    exception_ = std::current_exception();
  }
  return !halted();
}

MinimizerSummary LibraryRun::finish(std::vector<double>& x, StopReason reason, std::string message) {
  accept_best();
  if (exception_) std::rethrow_exception(exception_);
  run_.finish(reason, std::move(message));
  x = best_x_;
  return run_.summary();
}

}  // namespace shellmatch
