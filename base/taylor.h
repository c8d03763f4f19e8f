#pragma once
/// \file
/// Does a derivative belong to its function? Not by closeness at one step, but by the order of what is left over:
/// |f(t) - f(0) - t f'(0)| falls with t^2 if f' is right and with t if it is not.

#include <functional>
#include <vector>

namespace shellmatch {

/// Slope of log y over log x between two measured pairs.
double order_between(double x_coarse, double y_coarse, double x_fine, double y_fine);

/// Steps at which the remainder is measured: from `largest` down by `decades` powers of ten. `largest` has to be
/// small enough for the third order not to show and the smallest large enough for rounding not to.
struct TaylorSteps {
  double largest = 1e-3;
  int decades = 3;
};

/// The remainder at each step and its order within each decade.
struct TaylorRemainder {
  std::vector<double> steps, remainders;  ///< decades + 1 of each, from the largest step down
  std::vector<double> orders;             ///< one for each decade

  /// Is the order 2 in every decade?
  bool is_second_order(double tolerance = 0.1) const;
};

TaylorRemainder taylor_remainder(const std::function<double(double)>& f, double derivative, const TaylorSteps& steps = {});

/// Where three decades fit between rounding and the third order: what is known of f near 0.
struct TaylorScale {
  double rounding = 0;   ///< what f wavers by when its argument hardly moves
  double curvature = 0;  ///< f''(0), roughly
  double smallest = 0;   ///< step from which on the remainder stands out from rounding a hundredfold; 0 if none does

  /// Do `decades` decades from `smallest` up end within the reach?
  bool fits(double reach, int decades) const;
  /// Those decades. \pre fits()
  TaylorSteps steps(int decades) const;
};

/// Looks at f within [-reach, reach]; does not use a derivative. Curvature and steps are 0 where f cannot be evaluated
/// there (not finite) or is straight but for rounding.
TaylorScale taylor_scale(const std::function<double(double)>& f, double reach);

}  // namespace shellmatch
