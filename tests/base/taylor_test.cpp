// The order of the Taylor remainder tells a right derivative from a wrong one, and the scale finds where it shows.

#include "base/taylor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shellmatch {
namespace {

double f(double t) { return std::exp(std::sin(1 + t)); }
const double slope = std::cos(1.0) * f(0);

TEST(Taylor, OrderIsTwoForTheDerivativeAndOneForAnother) {
  const TaylorRemainder right = taylor_remainder(f, slope), wrong = taylor_remainder(f, 1.01 * slope);
  ASSERT_EQ(right.orders.size(), 3u);
  ASSERT_EQ(right.steps.size(), 4u);
  EXPECT_NEAR(right.steps.back(), 1e-6, 1e-18);
  EXPECT_TRUE(right.is_second_order(0.01));
  EXPECT_FALSE(wrong.is_second_order());
  EXPECT_NEAR(wrong.orders.back(), 1, 0.01);
}

TEST(Taylor, ARemainderThatIsNoNumberHasNoOrder) {
  EXPECT_FALSE(taylor_remainder([](double t) { return t == 0 ? 0 : std::nan(""); }, 0).is_second_order());
  EXPECT_FALSE(TaylorRemainder{}.is_second_order());
}

// Whatever stands beside the function and hides its small steps, the three decades lie above that.
TEST(Taylor, ScaleStaysAboveRounding) {
  for (const double offset : {0.0, 1e2, 1e4}) {
    const auto shifted = [&](double t) { return offset + f(t); };
    const TaylorScale scale = taylor_scale(shifted, 0.1);
    ASSERT_TRUE(scale.fits(0.1, 3)) << offset;
    EXPECT_TRUE(taylor_remainder(shifted, slope, scale.steps(3)).is_second_order()) << offset;
    EXPECT_FALSE(taylor_remainder(shifted, 1.01 * slope, scale.steps(3)).is_second_order()) << offset;
    const double second = (std::cos(1.0) * std::cos(1.0) - std::sin(1.0)) * f(0);
    EXPECT_NEAR(scale.curvature, second, 0.05 * std::abs(second)) << offset;
  }
  const TaylorScale hidden = taylor_scale([](double t) { return 1e12 + f(t); }, 0.1);
  EXPECT_FALSE(hidden.fits(0.1, 3));
}

// The argument rounds as well: x = 1 + t.
TEST(Taylor, ScaleKnowsThatArgumentsAreRounded) {
  const auto rounded = [](double t) {
    const volatile double x = 1 + t;
    return 1e3 * (x - 1) + 1e-3 * (x - 1) * (x - 1);
  };
  const TaylorScale scale = taylor_scale(rounded, 100);
  EXPECT_GT(scale.rounding, 1e-14);
}

// At the reach the fourth order is a hundred times the second.
TEST(Taylor, TheSecondOrderIsFoundBelowAGreaterFourth) {
  const auto f = [](double t) { return 1 + 0.3 * t + t * t + 1e4 * t * t * t * t; };
  const TaylorScale scale = taylor_scale(f, 0.1);
  ASSERT_TRUE(scale.fits(0.1, 3));
  EXPECT_NEAR(scale.curvature, 2, 0.2);
  EXPECT_TRUE(taylor_remainder(f, 0.3, scale.steps(3)).is_second_order());
  EXPECT_FALSE(taylor_remainder(f, 0.301, scale.steps(3)).is_second_order());
}

TEST(Taylor, StraightOrBrokenFunctionsHaveNoScale) {
  EXPECT_EQ(taylor_scale([](double t) { return 1 + 3 * t; }, 0.1).smallest, 0);
  EXPECT_EQ(taylor_scale([](double) { return 0.0; }, 0.1).smallest, 0);
  EXPECT_EQ(taylor_scale([](double t) { return std::sqrt(0.05 + t); }, 0.1).smallest, 0);
}

}  // namespace
}  // namespace shellmatch
