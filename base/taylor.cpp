#include "base/taylor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

double order_between(double x_coarse, double y_coarse, double x_fine, double y_fine) {
  return std::log(y_coarse / y_fine) / std::log(x_coarse / x_fine);
}

bool TaylorRemainder::is_second_order(double tolerance) const {
  // Written so that NaN fails.
  return !orders.empty() &&
         std::all_of(orders.begin(), orders.end(), [&](double o) { return std::abs(o - 2) <= tolerance; });
}

TaylorRemainder taylor_remainder(const std::function<double(double)>& f, double derivative, const TaylorSteps& steps) {
  const double at_zero = f(0.0);
  TaylorRemainder result;
  double t = steps.largest;
  for (int decade = 0; decade <= steps.decades; ++decade, t *= 0.1) {
    result.steps.push_back(t);
    result.remainders.push_back(std::abs(f(t) - at_zero - t * derivative));
    if (decade > 0)
      result.orders.push_back(
          order_between(result.steps[decade - 1], result.remainders[decade - 1], t, result.remainders[decade]));
  }
  return result;
}

bool TaylorScale::fits(double reach, int decades) const {
  return smallest > 0 && smallest * std::pow(10.0, decades) <= reach;
}

TaylorSteps TaylorScale::steps(int decades) const { return {smallest * std::pow(10.0, decades), decades}; }

TaylorScale taylor_scale(const std::function<double(double)>& f, double reach, int decades) {
  const double at_zero = f(0.0);
  TaylorScale scale;
  scale.rounding = std::numeric_limits<double>::epsilon() * std::abs(at_zero);
  // At these steps a smooth function is linear up to rounding, so the second difference measures the
  // rounding. The differences are one-sided: symmetric arguments are rounded symmetrically, and their errors
  // would cancel.
  for (const double share : {1e-8, 1.7e-8, 2.3e-8, 3.1e-8, 4.3e-8, 5.9e-8}) {
    const double t = share * reach;
    scale.rounding = std::max(scale.rounding, std::abs(f(2 * t) - 2 * f(t) + at_zero));
  }
  // Far out the fourth order may hide the second: the curvature is taken at the end of the decades that follow from it.
  double end = reach;
  for (bool is_shorter = true; is_shorter;) {
    const double bend = f(end) + f(-end) - 2 * at_zero;
    if (!std::isfinite(bend) || std::abs(bend) <= 100 * scale.rounding) {
      scale.curvature = scale.smallest = 0;
      break;
    }
    scale.curvature = bend / (end * end);
    scale.smallest = std::sqrt(2 * 100 * scale.rounding / std::abs(scale.curvature));
    const double next = scale.smallest * std::pow(10.0, decades);
    is_shorter = next < 0.5 * end;
    end = next;
  }
  return scale;
}

}  // namespace shellmatch
