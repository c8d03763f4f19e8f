#include "solvers/methods/fletcher_reeves.h"

#include "solvers/line_search/line_search.h"
#include "solvers/minimization_run.h"
#include "solvers/vector_ops.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

namespace {

constexpr double greatest_change = 10;  // factor between an accepted alpha and the next first trial

// Decay per step of the remembered second derivative, of which the maximum with the new estimate is used.
// Second derivatives along successive directions differ by a factor of two and more, and without memory every
// other first trial would be too long: with it a step takes 1.04 trials instead of 1.4 (measured on a
// registration problem in the plane with 18,000 unknowns), at the same decrease.
constexpr double bend_memory = 0.3;

// Quantities of the last accepted step.
struct LastStep {
  double alpha = 0;
  double slope = 0;     // at its start
  double decrease = 0;  // value before minus value after
  double bend = 0;      // second derivative along it, per unit of length
};

// First trial for a direction with this slope and length.
double first_alpha(const FletcherReevesOptions& options, const LastStep& last, const DirectionSize& d) {
  double alpha = last.alpha * options.step_growth;
  switch (options.initial_step) {
    case InitialStep::memory: return alpha;
    case InitialStep::slope: alpha *= last.slope / d.slope; break;
    case InitialStep::decrease: alpha = -2 * last.decrease / d.slope; break;
    case InitialStep::curvature:
      if (last.bend > 0) alpha = -d.slope / (last.bend * d.length * d.length);
      break;
  }
  return std::clamp(alpha, last.alpha / greatest_change, last.alpha * greatest_change);
}

LineSearchOptions line_search_options(const FletcherReevesOptions& o) {
  return {.armijo = o.armijo,
          .curvature = o.curvature,
          .interpolation = o.interpolation,
          .contraction = o.contraction,
          .max_trials = o.max_trials,
          .gradient_trials = o.gradient_trials};
}

}  // namespace

MinimizerSummary FletcherReeves::minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                                          const IterationCallback& callback) const {
  MinimizationRun run(objective, stop, callback);
  std::vector<double> g(run.size());
  if (!run.start(x, g)) return run.summary();

  std::vector<double> d(run.size());
  Line line(run);
  const LineSearchOptions search = line_search_options(options_);
  double value = run.start_value(), gradient_norm = run.start_gradient_norm(), beta = 0;
  int since_restart = 0;
  LastStep last;
  while (!run.over()) {
    DirectionSize size = conjugate_direction(g, beta, d);
    // Written so that NaN and infinity restart as well.
    if (beta != 0 && !(size.slope < -options_.least_cosine * gradient_norm * size.length)) {
      beta = 0;
      size = conjugate_direction(g, beta, d);
    }
    if (beta == 0) since_restart = 0;

    const double alpha = last.alpha > 0 ? first_alpha(options_, last, size) : options_.first_step / size.length;
    line.lay(x, d, value, size.slope);
    const LineSearchResult found = search_line(line, alpha, search);
    if (!found.success) {
      if (beta == 0 || run.out_of_time()) {
        run.finish_without_descent(infeasible_end(line, found));
      } else {
        beta = 0;  // next, the steepest descent with a new first step
        last.alpha = 0;
      }
      continue;
    }

    const LinePoint& p = found.point;
    last = {.alpha = p.alpha,
            .slope = size.slope,
            .decrease = value - p.value,
            .bend = std::max((p.slope - size.slope) / (p.alpha * size.length * size.length), bend_memory * last.bend)};
    const double squared = p.gradient_norm * p.gradient_norm, squared_before = gradient_norm * gradient_norm;
    const bool needs_overlap = options_.orthogonality > 0 || options_.update != ConjugateUpdate::fletcher_reeves;
    const double overlap = needs_overlap ? dot(line.gradient, g) : 0;
    beta = squared / squared_before;
    if (options_.update == ConjugateUpdate::bounded_polak_ribiere)
      beta = std::clamp((squared - overlap) / squared_before, -beta, beta);
    ++since_restart;
    if ((options_.restart_every > 0 && since_restart >= options_.restart_every) ||
        (options_.orthogonality > 0 && std::abs(overlap) >= options_.orthogonality * squared))
      beta = 0;

    std::swap(x, line.x);
    std::swap(g, line.gradient);
    value = p.value;
    gradient_norm = p.gradient_norm;
    run.accept(p.evaluation(), p.alpha * size.length);
  }
  return run.summary();
}

}  // namespace shellmatch
