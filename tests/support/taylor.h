#pragma once
/// \file
/// Does a derivative belong to its function? Not by closeness at one step, but by the order of what is left over:
/// |f(t) - f(0) - t f'(0)| falls with t^2 if f' is right and with t if it is not.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace shellmatch::test {

/// Slope of log y over log x between the first and the last of measured pairs.
inline double order_between(double x_coarse, double y_coarse, double x_fine, double y_fine) {
  return std::log(y_coarse / y_fine) / std::log(x_coarse / x_fine);
}

/// Steps at which the remainder is measured: from `largest` down by `decades` powers of ten. `largest` has to be
/// small enough for the third order not to show and the smallest large enough for rounding not to.
struct TaylorSteps {
  double largest = 1e-3;
  int decades = 3;
};

/// Order of the Taylor remainder of f, a function of one number, within each decade of steps.
template <class Function>
std::vector<double> taylor_orders(Function&& f, double derivative, const TaylorSteps& steps) {
  const double at_zero = f(0.0);
  std::vector<double> orders;
  double t = steps.largest;
  double remainder = std::abs(f(t) - at_zero - t * derivative);
  for (int decade = 0; decade < steps.decades; ++decade) {
    const double next = 0.1 * t;
    const double next_remainder = std::abs(f(next) - at_zero - next * derivative);
    orders.push_back(order_between(t, remainder, next, next_remainder));
    t = next;
    remainder = next_remainder;
  }
  return orders;
}

/// Is the order 2 within `tolerance` in every decade? \pre f''(0) != 0: along a direction in which f is linear
/// the remainder is rounding, which has no order.
template <class Function>
::testing::AssertionResult has_derivative(Function&& f, double derivative, const TaylorSteps& steps = {},
                                          double tolerance = 0.1) {
  const auto orders = taylor_orders(f, derivative, steps);
  bool good = true;
  for (const double o : orders) good = good && std::abs(o - 2) <= tolerance;
  auto result = good ? ::testing::AssertionSuccess() : ::testing::AssertionFailure();
  result << "order of the Taylor remainder by decade:";
  for (const double o : orders) result << " " << o;
  return result;
}

}  // namespace shellmatch::test
