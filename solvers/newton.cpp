#include "solvers/newton.h"

#include "base/large_vector.h"
#include "solvers/line_search.h"
#include "solvers/minimization_run.h"
#include "solvers/vector_ops.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

/// Vectors of the linear solver, kept over the steps.
struct LinearSolver {
  explicit LinearSolver(std::size_t n) : r(n), z(n), p(n), hp(n) {}
  LargeVector<double> r, z, p, hp;

  /// Preconditioned conjugate gradients for H d = -g from d = 0. Returns the number of iterations.
  int solve(const SecondOrderObjective& objective, std::span<const double> g, std::span<double> d, double tolerance,
            int max_iterations) {
    std::fill(d.begin(), d.end(), 0.0);
    for_pieces(r.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) r[i] = -g[i];
    });
    objective.precondition(r, z);
    std::copy(z.begin(), z.end(), p.begin());
    double rz = dot(r, z);
    const double target = tolerance * tolerance * rz;
    int k = 0;
    for (; k < max_iterations && rz > target; ++k) {
      objective.apply_second_derivative(p, hp);
      const double curvature = dot(p, hp);
      if (!(curvature > 0)) break;  // a direction without stiffness: what has been found so far will do
      const double alpha = rz / curvature;
      for_pieces(r.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          d[i] += alpha * p[i];
          r[i] -= alpha * hp[i];
        }
      });
      objective.precondition(r, z);
      const double next = dot(r, z);
      const double beta = next / rz;
      rz = next;
      for_pieces(r.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) p[i] = z[i] + beta * p[i];
      });
    }
    if (k == 0) std::copy(z.begin(), z.end(), d.begin());
    return k;
  }
};

}  // namespace

MinimizerSummary Newton::minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                                  const IterationCallback& callback) const {
  MinimizationRun run(objective, stop, callback);
  auto* model = dynamic_cast<SecondOrderObjective*>(&objective);
  std::vector<double> g(run.size());
  if (!run.start(x, g)) return run.summary();
  if (model == nullptr) {
    run.finish(StopReason::library, "the objective has no second derivative to offer");
    return run.summary();
  }
  std::vector<double> d(run.size());
  LinearSolver linear(run.size());
  Line line(run);
  const LineSearchOptions search{.armijo = options_.armijo, .curvature = 0, .interpolation = Interpolation::cubic,
                                 .contraction = 0.5, .max_trials = options_.max_trials, .gradient_trials = 2};
  double value = run.start_value(), gradient_norm = run.start_gradient_norm();
  const double least = std::min(options_.min_forcing, options_.max_forcing);
  double ratio = 0;  // of gradient norms, after the last step and before it
  while (!run.over()) {
    model->prepare_second_derivative(x);
    const double relative = gradient_norm / run.start_gradient_norm();
    const double forcing = std::min(std::clamp(0.9 * ratio * ratio, least, options_.max_forcing), std::sqrt(relative));
    int n_restraints = 0;
    do linear.solve(*model, g, d, forcing, options_.max_linear_iterations);
    while (n_restraints++ < options_.max_restraints && model->restrain(x, d));
    DirectionSize size = direction_size(g, d);
    if (!(size.slope < 0)) {
      run.finish(StopReason::no_descent);
      break;
    }
    line.lay(x, d, value, size.slope);
    LineSearchResult found = search_line(line, 1.0, search);
    if (!found.success) {
      model->precondition(g, d);
      scale(-1.0, d);
      size = direction_size(g, d);
      line.lay(x, d, value, size.slope);
      found = search_line(line, 1.0, search);
      if (!found.success) {
        run.finish(StopReason::no_descent);
        break;
      }
    }
    std::swap(x, line.x);
    std::swap(g, line.gradient);
    value = found.point.value;
    ratio = found.point.gradient_norm / gradient_norm;
    gradient_norm = found.point.gradient_norm;
    run.accept(found.point.evaluation(), found.point.alpha * size.length);
  }
  return run.summary();
}

}  // namespace shellmatch
