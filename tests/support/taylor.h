#pragma once
/// \file
/// base/taylor.h as an assertion.

#include "base/taylor.h"

#include <gtest/gtest.h>

namespace shellmatch::test {

/// Is the order of the Taylor remainder of f 2 within `tolerance` in every decade? \pre f''(0) != 0: along a
/// direction in which f is linear the remainder is rounding, which has no order.
template <class Function>
::testing::AssertionResult has_derivative(Function&& f, double derivative, const TaylorSteps& steps = {},
                                          double tolerance = 0.1) {
  const TaylorRemainder remainder = taylor_remainder(std::ref(f), derivative, steps);
  auto result = remainder.is_second_order(tolerance) ? ::testing::AssertionSuccess() : ::testing::AssertionFailure();
  result << "order of the Taylor remainder by decade:";
  for (const double o : remainder.orders) result << " " << o;
  return result;
}

}  // namespace shellmatch::test
