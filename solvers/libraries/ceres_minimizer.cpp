#include "solvers/libraries/ceres_minimizer.h"

#include "base/error.h"
#include "solvers/libraries/library_run.h"

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <glog/logging.h>

#include <exception>
#include <limits>

namespace shellmatch {

namespace {

class CeresFunction final : public ceres::FirstOrderFunction {
 public:
  CeresFunction(LibraryRun& run, std::size_t n) : run_(run), n_(n) {}
  bool Evaluate(const double* x, double* value, double* gradient) const override {
    const Evaluation at =
        run_.evaluate({x, n_}, gradient ? std::span<double>(gradient, n_) : std::span<double>());
    *value = at.value;
    return at.feasible;
  }
  int NumParameters() const override { return static_cast<int>(n_); }

 private:
  LibraryRun& run_;
  std::size_t n_;
};

class AcceptedStep final : public ceres::IterationCallback {
 public:
  explicit AcceptedStep(LibraryRun& run) : run_(run) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return run_.accept_best() ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }

 private:
  LibraryRun& run_;
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
    case CeresMethod::steepest_descent:
      return ceres::STEEPEST_DESCENT;
    case CeresMethod::ncg:
      return ceres::NONLINEAR_CONJUGATE_GRADIENT;
    case CeresMethod::bfgs:
      return ceres::BFGS;
    case CeresMethod::lbfgs:
      break;
  }
  return ceres::LBFGS;
}

ceres::NonlinearConjugateGradientType conjugate_gradient_type(CeresConjugateGradient type) {
  switch (type) {
    case CeresConjugateGradient::fletcher_reeves:
      return ceres::FLETCHER_REEVES;
    case CeresConjugateGradient::polak_ribiere:
      return ceres::POLAK_RIBIERE;
    case CeresConjugateGradient::hestenes_stiefel:
      break;
  }
  return ceres::HESTENES_STIEFEL;
}

ceres::LineSearchInterpolationType interpolation_type(CeresInterpolation type) {
  switch (type) {
    case CeresInterpolation::bisection:
      return ceres::BISECTION;
    case CeresInterpolation::quadratic:
      return ceres::QUADRATIC;
    case CeresInterpolation::cubic:
      break;
  }
  return ceres::CUBIC;
}

ceres::GradientProblemSolver::Options library_options(CeresMethod method, const CeresOptions& o) {
  ceres::GradientProblemSolver::Options to;
  to.line_search_direction_type = direction_type(method);
  to.line_search_type = o.line_search_type == CeresLineSearch::armijo ? ceres::ARMIJO : ceres::WOLFE;
  to.nonlinear_conjugate_gradient_type = conjugate_gradient_type(o.nonlinear_conjugate_gradient_type);
  to.line_search_interpolation_type = interpolation_type(o.line_search_interpolation_type);
  to.max_lbfgs_rank = o.max_lbfgs_rank;
  to.use_approximate_eigenvalue_bfgs_scaling = o.use_approximate_eigenvalue_bfgs_scaling;
  to.min_line_search_step_size = o.min_line_search_step_size;
  to.line_search_sufficient_function_decrease = o.line_search_sufficient_function_decrease;
  to.max_line_search_step_contraction = o.max_line_search_step_contraction;
  to.min_line_search_step_contraction = o.min_line_search_step_contraction;
  to.max_num_line_search_step_size_iterations = o.max_num_line_search_step_size_iterations;
  to.max_num_line_search_direction_restarts = o.max_num_line_search_direction_restarts;
  to.line_search_sufficient_curvature_decrease = o.line_search_sufficient_curvature_decrease;
  to.max_line_search_step_expansion = o.max_line_search_step_expansion;
  to.max_num_iterations = std::numeric_limits<int>::max();
  to.max_solver_time_in_seconds = std::numeric_limits<double>::max();
  to.function_tolerance = to.gradient_tolerance = to.parameter_tolerance = 0;
  to.logging_type = ceres::SILENT;
  return to;
}

// Ceres' messages have several lines.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text;
}

}  // namespace

CeresMinimizer::CeresMinimizer(CeresMethod method, const CeresOptions& options)
    : method_(method), options_(options) {
  std::string error;
  if (!library_options(method, options).IsValid(&error))
    throw_input_error("solver.ceres: the options do not fit {}: {}", name(), one_line(error));
}

MinimizerSummary CeresMinimizer::minimize(Objective& objective, std::vector<double>& x,
                                          const StopOptions& stop, const IterationCallback& callback) const {
  const std::size_t n = objective.size();
  if (method_ == CeresMethod::bfgs && n > static_cast<std::size_t>(options_.max_bfgs_size))
    throw_input_error(
        "solver.name: ceres_bfgs keeps a dense matrix and is limited to solver.ceres.max_bfgs_size = {} "
        "unknowns, but there are {}; use ceres_lbfgs or lbfgs",
        options_.max_bfgs_size, n);
  LibraryRun run(objective, x, stop, callback);
  if (!run.start()) return run.finish(x, StopReason::library, {});

  const QuietGlog quiet;
  AcceptedStep accepted_step(run);
  ceres::GradientProblemSolver::Options library = library_options(method_, options_);
  library.callbacks.push_back(&accepted_step);
  const ceres::GradientProblem problem(new CeresFunction(run, n));
  ceres::GradientProblemSolver::Summary report;
  std::vector<double> solution = x;
  // `run` stores exceptions of the objective; those caught here are Ceres' own.
  try {
    ceres::Solve(library, problem, solution.data(), &report);
  } catch (const std::exception& error) {
    return run.finish(x, StopReason::library, "Ceres threw: " + one_line(error.what()));
  }
  return run.finish(x, StopReason::library, "Ceres: " + one_line(report.message));
}

}  // namespace shellmatch
