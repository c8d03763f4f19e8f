#include "solvers/methods/lbfgs.h"

#include "solvers/methods/inverse_hessian.h"
#include "solvers/line_search/line_search.h"
#include "solvers/minimization_run.h"
#include "solvers/vector_ops.h"

#include <cmath>
#include <utility>

namespace shellmatch {

MinimizerSummary Lbfgs::minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                                 const IterationCallback& callback) const {
  MinimizationRun run(objective, stop, callback);
  std::vector<double> g(run.size());
  if (!run.start(x, g)) return run.summary();

  const LineSearchOptions search{.armijo = options_.armijo,
                                 .curvature = options_.curvature,
                                 .interpolation = options_.interpolation,
                                 .contraction = options_.contraction,
                                 .max_trials = options_.max_trials};
  LimitedMemoryInverseHessian inverse_hessian(run.size(), static_cast<std::size_t>(options_.memory),
                                              options_.least_cosine);
  std::vector<double> d(run.size());
  Line line(run);
  double value = run.start_value(), last_step = 0;
  while (!run.over()) {
    inverse_hessian.descend(g, d);
    DirectionSize size = direction_size(g, d);
    if (!inverse_hessian.empty() && !(size.slope < 0 && std::isfinite(size.length))) {
      inverse_hessian.clear();
      size = conjugate_direction(g, 0, d);
    }
    // Without an estimate of second derivatives, the steepest descent has no natural step length.
    const double alpha = !inverse_hessian.empty() ? 1 : (last_step > 0 ? last_step : options_.first_step) / size.length;
    line.lay(x, d, value, size.slope);
    const LineSearchResult found = search_line(line, alpha, search);
    if (!found.success) {
      if (inverse_hessian.empty() || run.out_of_time()) run.finish_without_descent(infeasible_end(line, found));
      inverse_hessian.clear();
      continue;
    }
    inverse_hessian.add(x, line.x, g, line.gradient);
    std::swap(x, line.x);
    std::swap(g, line.gradient);
    value = found.point.value;
    last_step = found.point.alpha * size.length;
    run.accept(found.point.evaluation(), last_step);
  }
  return run.summary();
}

}  // namespace shellmatch
