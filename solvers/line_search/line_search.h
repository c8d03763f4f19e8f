#pragma once
/// \file
/// The line search of the built-in methods: backtracking to the Armijo condition and, optionally, bracketing
/// to the weak Wolfe conditions. Numbers of equations and pages are those of Nocedal & Wright, Numerical
/// Optimization, 2nd edition (2006).

#include "solvers/minimization_run.h"
#include "solvers/solver_options.h"

#include <cstddef>
#include <span>
#include <vector>

namespace shellmatch {

/// Options of a line search. The methods set them from their own options.
struct LineSearchOptions {
  double armijo = 1e-4;  ///< c1 of (3.4): share of the linear decrease that a step must reach, in (0, 0.5)
  double curvature = 0;  ///< c2 of (3.6b): the slope must rise to this share of the initial slope; 0: no such condition
  Interpolation interpolation = Interpolation::cubic;
  double contraction = 0.5;  ///< factor on a step that is halved or whose end cannot be evaluated, in (0, 1)
  int max_trials = 40;
  /// Number of trials that are evaluated with their gradient. Later trials are evaluated by value alone until
  /// one is accepted. A value costs 0.55 times a value with gradient, so evaluating the gradient at once is
  /// cheaper if a step takes fewer than 2.2 trials on average. It also yields the slope, and so a cubic
  /// instead of a parabola.
  int gradient_trials = 2;
};

/// One point of the line.
struct LinePoint {
  double alpha = 0;
  double value = 0;
  double slope = 0;          ///< derivative along the line; only where `has_gradient`
  double gradient_norm = 0;  ///< only where `has_gradient`; so is the next
  double l2_gradient_norm = 0;
  bool feasible = false;
  bool has_gradient = false;

  Evaluation evaluation() const { return {feasible, value, gradient_norm, l2_gradient_norm}; }
};

/// The function alpha -> f(x + alpha d). It owns the trial point and the gradient there; the method swaps
/// them with its own vectors once a step is accepted.
class Line {
 public:
  explicit Line(MinimizationRun& run) : run_(run) {}

  /// Sets the line through `base` along `direction`; both must not change during the search. `slope` is the
  /// product of gradient and direction, negative.
  void lay(std::span<const double> base, std::span<const double> direction, double value, double slope);

  /// Frees x and gradient until the next lay().
  void release() {
    std::vector<double>().swap(x);
    std::vector<double>().swap(gradient);
  }

  const LinePoint& start() const { return start_; }
  LinePoint at(double alpha, bool with_gradient);
  bool out_of_time() const { return run_.out_of_time(); }

  std::vector<double> x;         ///< the last trial point
  std::vector<double> gradient;  ///< at x, if the trial was evaluated with its gradient

 private:
  MinimizationRun& run_;
  std::span<const double> base_, direction_;
  LinePoint start_;
};

/// Outcome of a search. On success, line.x and line.gradient belong to `point`.
struct LineSearchResult {
  bool success = false;
  bool ends_infeasible = false;  ///< the last trial, line.x, could not be evaluated
  LinePoint point;
  int n_trials = 0;
};

/// The last trial of a search that failed if it could not be evaluated, otherwise empty.
inline std::span<const double> infeasible_end(const Line& line, const LineSearchResult& found) {
  return found.ends_infeasible ? std::span<const double>(line.x) : std::span<const double>();
}

/// Finds a step that lowers the value and satisfies the Armijo condition (3.4) and, if options.curvature > 0,
/// the weak Wolfe condition (3.6b). The first trial is `first_alpha` > 0. A trial that cannot be evaluated
/// contracts the step. The bracketing is that of Lewis & Overton, Nonsmooth optimization via quasi-Newton
/// methods (2013), algorithm 2.6, with interpolation (page 57) in place of bisection. After the last trial,
/// the lowest point that satisfies the Armijo condition is accepted; the search fails only if there is none.
LineSearchResult search_line(Line& line, double first_alpha, const LineSearchOptions& options);

/// Minimiser of the cubic that interpolates values and slopes at a and b (3.59), or, where b has no slope, of
/// the parabola that interpolates a's value and slope and b's value (3.58). NaN where there is no minimiser.
double interpolated_minimum(const LinePoint& a, const LinePoint& b);

}  // namespace shellmatch
