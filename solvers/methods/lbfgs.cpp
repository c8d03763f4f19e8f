#include "solvers/methods/lbfgs.h"

#include "solvers/line_search/line_search.h"
#include "solvers/minimization_run.h"
#include "solvers/vector_ops.h"

#include <cmath>
#include <utility>

namespace shellmatch {

LimitedMemoryInverseHessian::LimitedMemoryInverseHessian(std::size_t n, std::size_t memory, double least_cosine)
    : least_cosine_(least_cosine), pairs_(memory), alpha_(memory) {
  for (Pair& p : pairs_) {
    p.s.resize(n);
    p.y.resize(n);
  }
}

bool LimitedMemoryInverseHessian::add(std::span<const double> x0, std::span<const double> x1,
                                      std::span<const double> g0, std::span<const double> g1) {
  Pair& p = pairs_[next_];
  const PairProducts products = difference_pair(x0, x1, g0, g1, p.s, p.y);
  if (!(products.s_y > least_cosine_ * std::sqrt(products.s_s) * std::sqrt(products.y_y))) {
    if (count_ == pairs_.size()) --count_;
    return false;
  }
  p.rho = 1 / products.s_y;
  gamma_ = products.s_y / products.y_y;
  next_ = (next_ + 1) % pairs_.size();
  if (count_ < pairs_.size()) ++count_;
  return true;
}

void LimitedMemoryInverseHessian::descend(std::span<const double> g, std::span<double> d) {
  conjugate_direction(g, 0, d);
  if (count_ == 0) return;
  // Every sweep updates d and computes its product with the vector of the next sweep.
  double product = dot(d, newest(0).s);
  for (std::size_t i = 0; i < count_; ++i) {
    const Pair& p = newest(i);
    alpha_[i] = p.rho * product;
    product = add_scaled_and_dot(-alpha_[i], p.y, d, i + 1 < count_ ? newest(i + 1).s : p.y);
  }
  scale(gamma_, d);
  product *= gamma_;  // d.y of the oldest pair
  for (std::size_t i = count_; i-- > 0;) {
    const Pair& p = newest(i);
    product = add_scaled_and_dot(alpha_[i] - p.rho * product, p.s, d, i > 0 ? newest(i - 1).y : p.s);
  }
}

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
