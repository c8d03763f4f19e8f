#include "solvers/methods/newton.h"

#include "base/large_vector.h"
#include "solvers/line_search/line_search.h"
#include "solvers/methods/step_regularisation.h"
#include "solvers/minimization_run.h"
#include "solvers/vector_ops.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

/// Preconditioned conjugate gradients for H d = -g. Its vectors are there during a solution alone: what follows needs
/// as many.
class LinearSolver {
 public:
  LinearSolver(const SecondOrderObjective& objective, int max_iterations, std::size_t n)
      : objective_(objective), max_iterations_(max_iterations), n_(n) {}

  /// From d = 0, until the residual is this share of what it was, in the preconditioner's norm.
  void solve(std::span<const double> g, std::span<double> d, double tolerance) {
    take_vectors();
    std::fill(d.begin(), d.end(), 0.0);
    for_chunks(r_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) r_[i] = -g[i];
    });
    objective_.precondition(r_, z_);
    const double rz = dot(r_, z_);
    target_ = tolerance * tolerance * rz;
    if (iterate(d, rz) == 0) std::copy(z_.begin(), z_.end(), d.begin());
    free_vectors();
  }

  /// The same for H and g that have changed here and there since d was found: from d, to the same residual.
  void solve_again(std::span<const double> g, std::span<double> d) {
    take_vectors();
    objective_.apply_second_derivative(d, hp_);
    const double slope = dot(g, d), curvature = dot(d, hp_);
    // The model g.d + d.Hd / 2 only falls from where this begins: where it is negative there is descent in the end.
    const double share = slope + 0.5 * curvature < 0 ? 1.0 : -slope / curvature;
    for_chunks(r_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        d[i] *= share;
        r_[i] = -g[i] - share * hp_[i];
      }
    });
    objective_.precondition(r_, z_);
    iterate(d, dot(r_, z_));
    free_vectors();
  }

  long n_iterations() const { return n_iterations_; }  ///< so far

 private:
  void take_vectors() {
    for (LargeVector<double>* v : {&r_, &z_, &p_, &hp_}) v->resize(n_);
  }
  void free_vectors() {
    for (LargeVector<double>* v : {&r_, &z_, &p_, &hp_}) LargeVector<double>().swap(*v);
  }

  // From the residual r_ of d, preconditioned z_; rz is their product. Returns the number of iterations.
  int iterate(std::span<double> d, double rz) {
    std::copy(z_.begin(), z_.end(), p_.begin());
    int k = 0;
    for (; k < max_iterations_ && rz > target_; ++k) {
      objective_.apply_second_derivative(p_, hp_);
      const double curvature = dot(p_, hp_);
      if (!(curvature > 0)) break;  // a direction without stiffness: what has been found so far will do
      const double alpha = rz / curvature;
      for_chunks(r_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          d[i] += alpha * p_[i];
          r_[i] -= alpha * hp_[i];
        }
      });
      objective_.precondition(r_, z_);
      const double next = dot(r_, z_);
      const double beta = next / rz;
      rz = next;
      for_chunks(r_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) p_[i] = z_[i] + beta * p_[i];
      });
    }
    n_iterations_ += k;
    return k;
  }

  const SecondOrderObjective& objective_;
  int max_iterations_;
  std::size_t n_;
  long n_iterations_ = 0;
  double target_ = 0;
  LargeVector<double> r_, z_, p_, hp_;
};

}  // namespace

MinimizerSummary Newton::minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                                  const IterationCallback& callback) const {
  MinimizationRun run(objective, stop, callback);
  SecondOrderObjective* model = objective.second_order();
  std::vector<double> g(run.size());
  if (!run.start(x, g)) return run.summary();
  if (model == nullptr) {
    run.finish(StopReason::library, "the objective has no second derivative to offer");
    return run.summary();
  }
  std::vector<double> d(run.size()), g_model(run.size());
  LinearSolver linear(*model, options_.max_linear_iterations, run.size());
  StepRegularisation regularisation(options_, *model);
  Line line(run);
  const LineSearchOptions search{.armijo = options_.armijo,
                                 .curvature = 0,
                                 .interpolation = Interpolation::cubic,
                                 .contraction = 0.5,
                                 .max_trials = options_.max_trials,
                                 .gradient_trials = 2};
  double value = run.start_value(), gradient_norm = run.start_gradient_norm();
  const double least = std::min(options_.min_forcing, options_.max_forcing);
  double ratio = 0;  // of gradient norms, after the last step and before it
  // Of the next step: gains go with the squares of gradients, as in a quadratic model. Infinite where the last step's
  // gain was not the one that its model predicted, or the model already served two steps.
  constexpr double unknown = std::numeric_limits<double>::infinity();
  double expected_gain = unknown;
  while (!run.over()) {
    const bool has_own_model = !(expected_gain < options_.reuse_below * stop.relative_decrease * std::abs(value));
    if (has_own_model) model->prepare_second_derivative(x, regularisation.next_damping());
    else regularisation.keep_damping();
    const double relative = gradient_norm / run.start_gradient_norm();
    const double forcing = std::min(std::clamp(0.9 * ratio * ratio, least, options_.max_forcing), std::sqrt(relative));
    linear.solve(g, d, forcing);
    std::copy(g.begin(), g.end(), g_model.begin());
    while (!run.out_of_time() && regularisation.regularise(*model, x, d, g_model)) linear.solve_again(g_model, d);
    regularisation.contract(*model, x, g, d);
    DirectionSize size = direction_size(g, d);
    if (!(size.slope < 0)) {
      run.finish(StopReason::no_descent, model->what_of_model_is_not_finite(x));
      break;
    }
    line.lay(x, d, value, size.slope);
    LineSearchResult found = search_line(line, 1.0, search);
    if (!found.success && !has_own_model) {
      expected_gain = unknown;
      continue;
    }
    if (!found.success) {
      model->precondition(g, d);
      scale(-1.0, d);
      size = direction_size(g, d);
      if (!(size.slope < 0)) {
        run.finish(StopReason::no_descent, model->what_of_model_is_not_finite(x));
        break;
      }
      line.lay(x, d, value, size.slope);
      found = search_line(line, 1.0, search);
      if (!found.success) {
        run.finish_without_descent(infeasible_end(line, found));
        break;
      }
    }
    std::swap(x, line.x);
    std::swap(g, line.gradient);
    line.release();
    ratio = found.point.gradient_norm / gradient_norm;
    const double gain = value - found.point.value;
    const bool is_as_predicted = found.point.alpha == 1 && std::abs(gain + 0.5 * size.slope) < 0.1 * gain;
    expected_gain = has_own_model && is_as_predicted ? gain * ratio * ratio : unknown;
    value = found.point.value;
    gradient_norm = found.point.gradient_norm;
    run.accept(found.point.evaluation(), found.point.alpha * size.length, run.term_values(), found.point.alpha < 1,
               regularisation.is_restrained());
  }
  MinimizerSummary summary = run.summary();
  summary.linear_iterations = linear.n_iterations();
  summary.regularised_systems = regularisation.n_systems();
  return summary;
}

}  // namespace shellmatch
