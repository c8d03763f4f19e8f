#include "solvers/libraries/ceres_minimizer.h"

#include "base/error.h"
#include "solvers/minimization_run.h"
#include "solvers/vector_ops.h"

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <glog/logging.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <ranges>
#include <span>
#include <utility>

namespace shellmatch {

namespace {

/// What Ceres evaluates between two of its iterates, and its iterates as they are recorded.
class CeresRun {
 public:
  CeresRun(MinimizationRun& run, const std::vector<double>& x, const std::vector<double>& gradient)
      : run_(run), start_(x), start_gradient_(gradient), recorded_x_(x) {}

  /// Throws nothing: exceptions wait until Ceres has returned.
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) noexcept {
    if (exception_ || run_.over() || run_.out_of_time()) return false;
    if (std::exchange(is_first_, false) && std::ranges::equal(x, start_)) {  // Ceres begins with what is known
      value = run_.start_value();
      std::copy_n(start_gradient_.begin(), gradient.size(), gradient.begin());
      return true;
    }
    try {
      const Evaluation at = run_.evaluate(x, gradient);
      value = at.value;
      if (at.feasible) trials_.push_back({at, run_.term_values(), !gradient.empty()});
      return at.feasible;
    } catch (...) {
      exception_ = std::current_exception();
      return false;
    }
  }

  /// Records the iterate x, where Ceres found this value. False if Ceres is to stop.
  bool accept(double value, std::span<const double> x) noexcept {
    try {
      if (exception_ || run_.over()) return false;
      const double step = distance(x, recorded_x_);
      recorded_x_.assign(x.begin(), x.end());
      const auto has_value = [&](const Trial& trial) { return trial.has_gradient && trial.at.value == value; };
      const auto trial = std::ranges::find_if(trials_.rbegin(), trials_.rend(), has_value);
      if (trial != trials_.rend()) {
        run_.accept(trial->at, step, std::move(trial->terms));
      } else {
        std::vector<double> gradient(x.size());
        run_.accept(run_.evaluate(x, gradient), step);
      }
      trials_.clear();
    } catch (...) {
      exception_ = std::current_exception();
    }
    return !exception_ && !run_.over();
  }

  /// The same for the last iterate, with which Ceres calls nobody back where a tolerance is reached there.
  void accept_last(double value, std::span<const double> x) {
    if (!std::ranges::equal(x, recorded_x_)) accept(value, x);
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  struct Trial {
    Evaluation at;
    std::vector<double> terms;
    bool has_gradient;
  };
  MinimizationRun& run_;
  const std::vector<double>&start_, &start_gradient_;
  std::vector<double> recorded_x_;
  bool is_first_ = true;
  std::vector<Trial> trials_;  ///< since the last iterate
  std::exception_ptr exception_;
};

class CeresFunction final : public ceres::FirstOrderFunction {
 public:
  CeresFunction(CeresRun& run, std::size_t n) : run_(run), n_(n) {}
  bool Evaluate(const double* x, double* value, double* gradient) const override {
    return run_.evaluate({x, n_}, *value, gradient ? std::span<double>(gradient, n_) : std::span<double>());
  }
  int NumParameters() const override { return static_cast<int>(n_); }

 private:
  CeresRun& run_;
  std::size_t n_;
};

/// Called after every iteration, with the solution updated.
class AcceptedStep final : public ceres::IterationCallback {
 public:
  AcceptedStep(CeresRun& run, std::span<const double> solution) : run_(run), solution_(solution) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& at) override {
    if (at.iteration == 0) return ceres::SOLVER_CONTINUE;  // recorded as the start
    return run_.accept(at.cost, solution_) ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }

 private:
  CeresRun& run_;
  std::span<const double> solution_;
};

// Silences glog, by which Ceres reports every restart on the error stream; the summary has what matters.
class QuietGlog {
 public:
  QuietGlog() : before_(FLAGS_minloglevel) { FLAGS_minloglevel = google::GLOG_FATAL; }
  ~QuietGlog() { FLAGS_minloglevel = before_; }

 private:
  int before_;
};

ceres::LineSearchDirectionType direction_type(CeresMethod method) {
  switch (method) {
    case CeresMethod::steepest_descent: return ceres::STEEPEST_DESCENT;
    case CeresMethod::ncg: return ceres::NONLINEAR_CONJUGATE_GRADIENT;
    case CeresMethod::bfgs: return ceres::BFGS;
    case CeresMethod::lbfgs: break;
  }
  return ceres::LBFGS;
}

ceres::NonlinearConjugateGradientType conjugate_gradient_type(CeresConjugateGradient type) {
  switch (type) {
    case CeresConjugateGradient::fletcher_reeves: return ceres::FLETCHER_REEVES;
    case CeresConjugateGradient::polak_ribiere: return ceres::POLAK_RIBIERE;
    case CeresConjugateGradient::hestenes_stiefel: break;
  }
  return ceres::HESTENES_STIEFEL;
}

ceres::GradientProblemSolver::Options library_options(CeresMethod method, const CeresOptions& o,
                                                      const StopOptions& stop = {}) {
  ceres::GradientProblemSolver::Options to;
  to.line_search_direction_type = direction_type(method);
  to.line_search_type = o.line_search_type == CeresLineSearch::armijo ? ceres::ARMIJO : ceres::WOLFE;
  to.nonlinear_conjugate_gradient_type = conjugate_gradient_type(o.nonlinear_conjugate_gradient_type);
  to.max_lbfgs_rank = o.max_lbfgs_rank;
  to.function_tolerance = o.function_tolerance;
  to.gradient_tolerance = o.gradient_tolerance;
  to.parameter_tolerance = o.parameter_tolerance;
  to.max_num_iterations = stop.max_iterations;
  if (stop.max_seconds > 0) to.max_solver_time_in_seconds = stop.max_seconds;
  to.update_state_every_iteration = true;
  to.logging_type = ceres::SILENT;
  return to;
}

// Ceres' messages have several lines.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}

// Ends the run for Ceres' reason, unless the common rules or the caller have ended it.
void finish(MinimizationRun& run, const ceres::GradientProblemSolver::Summary& report, const StopOptions& stop) {
  const std::string message = "Ceres: " + one_line(report.message);
  switch (report.termination_type) {
    case ceres::CONVERGENCE: return run.finish(StopReason::converged, message);
    case ceres::NO_CONVERGENCE:
      return run.finish(
          run.summary().iterations >= stop.max_iterations ? StopReason::max_iterations : StopReason::max_seconds,
          message);
    default: return run.finish(StopReason::library, message);
  }
}

}  // namespace

CeresMinimizer::CeresMinimizer(CeresMethod method, const CeresOptions& options) : method_(method), options_(options) {
  std::string error;
  if (!library_options(method, options).IsValid(&error))
    throw_input_error("solver.ceres: the options do not fit {}: {}", name(), one_line(error));
}

MinimizerSummary CeresMinimizer::minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                                          const IterationCallback& callback) const {
  const std::size_t n = objective.size();
  if (method_ == CeresMethod::bfgs && n > static_cast<std::size_t>(options_.max_bfgs_size))
    throw_input_error(
        "solver.name: ceres_bfgs keeps a dense matrix and is limited to solver.ceres.max_bfgs_size = {} "
        "unknowns, but there are {}; use ceres_lbfgs or lbfgs",
        options_.max_bfgs_size, n);
  StopOptions rules = stop;
  rules.max_iterations = std::numeric_limits<int>::max();  // Ceres counts its own
  if (!options_.common_stop_rules) rules.relative_decrease = rules.gradient_norm = 0;
  MinimizationRun run(objective, rules, callback);
  std::vector<double> gradient(n);
  if (!run.start(x, gradient)) return run.summary();

  const QuietGlog quiet;
  CeresRun ceres_run(run, x, gradient);
  std::vector<double> solution = x;
  AcceptedStep accepted_step(ceres_run, solution);
  ceres::GradientProblemSolver::Options library = library_options(method_, options_, stop);
  library.callbacks.push_back(&accepted_step);
  const ceres::GradientProblem problem(new CeresFunction(ceres_run, n));
  ceres::GradientProblemSolver::Summary report;
  std::string thrown;
  // The objective's exceptions wait in `ceres_run`; those caught here are Ceres' own.
  try {
    ceres::Solve(library, problem, solution.data(), &report);
  } catch (const std::exception& error) {
    thrown = "Ceres threw: " + one_line(error.what());
  }
  ceres_run.accept_last(report.final_cost, solution);
  if (thrown.empty()) finish(run, report, stop);
  else run.finish(StopReason::library, thrown);
  x = std::move(solution);
  MinimizerSummary summary = run.summary();
  if (thrown.empty()) summary.library_reports = {{report.BriefReport(), report.FullReport()}};
  return summary;
}

}  // namespace shellmatch
