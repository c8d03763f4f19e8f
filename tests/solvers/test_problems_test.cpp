// The test problems themselves: what is wrong here would be blamed on the solvers.
#include "tests/support/test_problems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace shellmatch::testing {
namespace {

std::vector<std::unique_ptr<TestProblem>> all_problems() {
  auto problems = more_garbow_hillstrom();
  problems.push_back(log_barrier(10, 1e-2));
  problems.push_back(weighted_bowl(50));
  return problems;
}

// Remainder of the linear model along a random direction; of second order in t for a right gradient.
double remainder(TestProblem& p, const std::vector<double>& x, const std::vector<double>& g,
                 const std::vector<double>& d, double t) {
  std::vector<double> plus(x), minus(x);
  double slope = 0, f_plus = 0, f_minus = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    plus[i] += t * d[i];
    minus[i] -= t * d[i];
    slope += g[i] * d[i];
  }
  EXPECT_TRUE(p.evaluate(plus, f_plus, {}));
  EXPECT_TRUE(p.evaluate(minus, f_minus, {}));
  return std::abs((f_plus - f_minus) / (2 * t) - slope) / (1 + std::abs(slope));
}

TEST(TestProblems, GradientAgreesWithDifferencesToSecondOrder) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  for (const auto& p : all_problems()) {
    std::vector<double> x = p->start(), d(x.size()), g(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += uniform(random);
      d[i] = uniform(random);
    }
    double value = 0;
    ASSERT_TRUE(p->evaluate(x, value, g)) << p->name();
    const double coarse = remainder(*p, x, g, d, 1e-2), fine = remainder(*p, x, g, d, 1e-3);
    EXPECT_LT(fine, std::max(0.02 * coarse, 1e-9)) << p->name();
  }
}

TEST(TestProblems, MinimizerHasTheMinimumAndAZeroGradient) {
  for (const auto& p : all_problems()) {
    const std::vector<double> x = p->minimizer();
    if (x.empty()) continue;
    std::vector<double> g(x.size());
    double value = 0;
    ASSERT_TRUE(p->evaluate(x, value, g)) << p->name();
    EXPECT_EQ(p->check(value, x, 1e-14), "");
    for (const double d : g) EXPECT_NEAR(d, 0, 1e-12) << p->name();
  }
}

TEST(TestProblems, CheckRejectsAWrongValueAndAWrongPoint) {
  const auto p = extended_rosenbrock(4);
  EXPECT_EQ(p->check(0, {1, 1, 1, 1}, 1e-8), "");
  EXPECT_NE(p->check(1e-6, {1, 1, 1, 1}, 1e-8), "");
  EXPECT_NE(p->check(0, {1, 1, 1, 1.1}, 1e-8), "");
  EXPECT_NE(p->check(std::nan(""), {1, 1, 1, 1}, 1e-8), "");
}

// Values at the starts, as the paper's starts give them by hand.
TEST(TestProblems, ValuesAtTheStart) {
  const double expected[] = {24.2, 215, 19192, 14.203125, 2500};
  const auto problems = more_garbow_hillstrom();
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    double value = 0;
    ASSERT_TRUE(problems[i]->evaluate(problems[i]->start(), value, {}));
    EXPECT_NEAR(value, expected[i], 1e-9 * expected[i]) << problems[i]->name();
  }
}

}  // namespace
}  // namespace shellmatch::testing
