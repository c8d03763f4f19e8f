#include "solvers/line_search/line_search.h"

#include "solvers/vector_ops.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

constexpr double least_share = 0.1;      // of the bracket: bounds the contraction of a step from below
constexpr double greatest_share = 0.8;   // and from above, where the model fits badly
constexpr double least_expansion = 1.5;  // factor on a step that was too short
constexpr double greatest_expansion = 10;

// A step between `low`, the lowest point that satisfies the Armijo condition, and `high`, which is too far.
double inner_step(const LinePoint& low, const LinePoint& high, const LineSearchOptions& options) {
  const double width = high.alpha - low.alpha;
  if (options.interpolation == Interpolation::halving || !high.feasible) return low.alpha + options.contraction * width;
  LinePoint end = high;
  if (options.interpolation == Interpolation::quadratic) end.has_gradient = false;
  double alpha = interpolated_minimum(low, end);
  if (!std::isfinite(alpha)) alpha = low.alpha + options.contraction * width;
  return std::clamp(alpha, low.alpha + least_share * width, low.alpha + greatest_share * width);
}

// A step beyond `low`, whose slope is too steep: the zero of the secant through the slopes.
double longer_step(const LinePoint& before, const LinePoint& low) {
  const double bend = low.slope - before.slope;
  double alpha =
      bend > 0 ? low.alpha - low.slope * (low.alpha - before.alpha) / bend : std::numeric_limits<double>::infinity();
  return std::clamp(alpha, least_expansion * low.alpha, greatest_expansion * low.alpha);
}

}  // namespace

void Line::lay(std::span<const double> base, std::span<const double> direction, double value, double slope) {
  x.resize(base.size());
  gradient.resize(base.size());
  base_ = base;
  direction_ = direction;
  start_ = LinePoint{};
  start_.value = value;
  start_.slope = slope;
  start_.feasible = start_.has_gradient = true;
}

LinePoint Line::at(double alpha, bool with_gradient) {
  add_scaled(base_, alpha, direction_, x);
  const Evaluation e = run_.evaluate(x, with_gradient ? std::span<double>(gradient) : std::span<double>());
  LinePoint p{.alpha = alpha,
              .value = e.value,
              .slope = 0,
              .gradient_norm = e.gradient_norm,
              .l2_gradient_norm = e.l2_gradient_norm,
              .feasible = e.feasible,
              .has_gradient = e.feasible && with_gradient};
  if (p.has_gradient) p.slope = dot(gradient, direction_);
  return p;
}

double interpolated_minimum(const LinePoint& a, const LinePoint& b) {
  const double width = b.alpha - a.alpha;
  if (!b.has_gradient) {
    const double bend = b.value - a.value - a.slope * width;
    return bend > 0 ? a.alpha - a.slope * width * width / (2 * bend) : std::numeric_limits<double>::quiet_NaN();
  }
  const double d1 = a.slope + b.slope - 3 * (a.value - b.value) / (a.alpha - b.alpha);
  const double d2 = std::copysign(std::sqrt(d1 * d1 - a.slope * b.slope), width);
  return b.alpha - width * (b.slope + d2 - d1) / (b.slope - a.slope + 2 * d2);
}

LineSearchResult search_line(Line& line, double first_alpha, const LineSearchOptions& options) {
  const LinePoint start = line.start();
  LinePoint low = start, high, last;
  bool bracketed = false;
  LineSearchResult result;
  double alpha = first_alpha;
  while (result.n_trials < options.max_trials && !line.out_of_time()) {
    // The bracket is empty up to rounding.
    if (!(alpha > low.alpha) || (bracketed && !(alpha < high.alpha))) break;
    ++result.n_trials;
    const bool with_gradient = options.curvature > 0 || result.n_trials <= options.gradient_trials;
    last = line.at(alpha, with_gradient);
    // A step that leaves the value unchanged to the last bit is not a descent, even if (3.4) holds.
    if (!last.feasible || last.value > start.value + options.armijo * alpha * start.slope ||
        !(last.value < start.value)) {
      high = last;
      bracketed = true;
      alpha = inner_step(low, high, options);
    } else if (options.curvature > 0 && last.slope < options.curvature * start.slope) {
      const LinePoint before = low;
      low = last;
      // Points beyond cannot be evaluated. A step that lowers the value is accepted then, even if it is
      // short.
      if (bracketed && !high.feasible) break;
      alpha = bracketed ? inner_step(low, high, options) : longer_step(before, low);
    } else {
      low = last;
      break;
    }
  }
  result.success = low.alpha > 0;
  result.ends_infeasible = result.n_trials > 0 && !last.feasible;
  if (!result.success) return result;
  if (last.alpha != low.alpha || !low.has_gradient) low = line.at(low.alpha, true);
  result.point = low;
  result.success = low.feasible;  // the gradient may turn out not to be finite
  result.ends_infeasible = !low.feasible;
  return result;
}

}  // namespace shellmatch
