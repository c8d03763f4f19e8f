#pragma once
/// \file
/// Verification of a derivative by the order of the Taylor remainder: |f(t) - f(0) - t f'(0)| is O(t^2) if
/// f'(0) is right and only O(t) if it is not.

#include <functional>
#include <vector>

namespace shellmatch {

/// Order of convergence between two measured pairs: the slope of log y over log x.
double order_between(double x_coarse, double y_coarse, double x_fine, double y_fine);

/// Steps at which the remainder is measured: from `largest` down by `decades` powers of ten. `largest` must
/// be so small that terms of third order are negligible, and the smallest step so large that rounding is.
struct TaylorSteps {
  double largest = 1e-3;
  int decades = 3;
};

/// The remainder at each step and its order within each decade.
struct TaylorRemainder {
  std::vector<double> steps, remainders;  ///< decades + 1 of each, from the largest step down
  std::vector<double> orders;             ///< one for each decade

  /// True if the order is 2, up to the tolerance, in every decade.
  bool is_second_order(double tolerance = 0.1) const;
};

TaylorRemainder taylor_remainder(const std::function<double(double)>& f, double derivative,
                                 const TaylorSteps& steps = {});

/// Scales of f near 0, from which the steps of the measurement follow.
struct TaylorScale {
  double rounding = 0;   ///< error of f by rounding
  double curvature = 0;  ///< estimate of f''(0)
  double smallest = 0;   ///< least step whose remainder is 100 times the rounding; 0 if none

  /// True if `decades` decades from `smallest` upwards end within `reach`.
  bool fits(double reach, int decades) const;
  /// The steps of these decades. \pre fits()
  TaylorSteps steps(int decades) const;
};

/// Estimates the scales from values of f in [-reach, reach], for steps over so many decades; uses no derivative.
/// `curvature` and `smallest` are 0 where f is not finite there or is linear up to rounding.
TaylorScale taylor_scale(const std::function<double(double)>& f, double reach, int decades = 3);

}  // namespace shellmatch
