#include "solvers/libraries/nlopt_minimizer.h"

#include "solvers/libraries/library_run.h"
#include "solvers/vector_ops.h"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace shellmatch {

namespace {

nlopt_algorithm algorithm(NloptMethod method) {
  switch (method) {
    case NloptMethod::lbfgs: return NLOPT_LD_LBFGS;
    case NloptMethod::var1: return NLOPT_LD_VAR1;
    case NloptMethod::var2: return NLOPT_LD_VAR2;
    case NloptMethod::mma: return NLOPT_LD_MMA;
    case NloptMethod::ccsaq: break;
  }
  return NLOPT_LD_CCSAQ;
}

struct OptDeleter {
  void operator()(nlopt_opt opt) const { nlopt_destroy(opt); }
};
using Opt = std::unique_ptr<nlopt_opt_s, OptDeleter>;

struct Context {
  LibraryRun& run;
  nlopt_opt opt;
  int max_stalled;
  bool not_finite = false;  // the library requested a point with an entry that is not finite
  bool stalled = false;
};

// The cone over the best point, which replaces the function where it cannot be evaluated.
double cone(const LibraryRun& run, std::span<const double> x, std::span<double> gradient) {
  const double radius = distance(x, run.best_x()), slope = run.best_gradient_norm();
  if (!gradient.empty()) add_scaled(x, -1, run.best_x(), gradient);
  if (!gradient.empty()) scale(radius > 0 ? slope / radius : 0, gradient);
  return run.best_value() + slope * radius;
}

// The function that NLopt calls. It must not throw, because NLopt is written in C.
double evaluate(unsigned n, const double* x, double* gradient, void* data) {
  Context& context = *static_cast<Context*>(data);
  const std::span<const double> at_x(x, n);
  const std::span<double> g = gradient ? std::span<double>(gradient, n) : std::span<double>();
  const double stop_value = context.run.best_value();
  const auto halt = [&] {
    nlopt_force_stop(context.opt);
    return stop_value;
  };
  if (!std::isfinite(norm(at_x))) {
    context.not_finite = true;
    return halt();
  }
  const Evaluation at = context.run.evaluate(at_x, g);
  // The library evaluates trial points without gradient; a step is accepted once its gradient is known.
  if (at.feasible && gradient) context.run.accept_best();
  if (context.run.halted()) return halt();
  if (context.run.stalled_evaluations() > context.max_stalled) {
    context.stalled = true;
    return halt();
  }
  return at.feasible ? at.value : cone(context.run, at_x, g);
}

std::string words(nlopt_result result, const Context& context) {
  if (context.not_finite) return "it asked for a point that is not finite";
  if (context.stalled) return "no lower value in max_stalled_evaluations evaluations";
  const char* name = nlopt_result_to_string(result);
  return name ? name : "unknown result";
}

}  // namespace

MinimizerSummary NloptMinimizer::minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                                          const IterationCallback& callback) const {
  const std::size_t n = objective.size();
  LibraryRun run(objective, x, stop, callback);
  if (!run.start()) return run.finish(x, StopReason::library, {});

  std::string ending;
  int n_starts = 0;
  std::vector<double> point(n);
  while (!run.halted() && n_starts <= max_restarts_) {
    const Opt opt(nlopt_create(algorithm(method_), static_cast<unsigned>(n)));
    if (opt == nullptr) return run.finish(x, StopReason::library, "NLopt: out of memory");
    Context context{.run = run, .opt = opt.get(), .max_stalled = max_stalled_};
    nlopt_set_min_objective(opt.get(), evaluate, &context);
    run.begin_again();
    point = run.best_x();
    const double before = run.best_value();
    double value = before;
    const nlopt_result result = nlopt_optimize(opt.get(), point.data(), &value);
    ++n_starts;
    ending = words(result, context);
    if (!(run.best_value() < before)) break;
  }
  return run.finish(x, StopReason::library, fmt::format("NLopt: {} ({} restarts)", ending, std::max(n_starts - 1, 0)));
}

}  // namespace shellmatch
