#include "solvers/vector_ops.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace shellmatch {
namespace {

std::vector<double> random_vector(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> x(n);
  for (double& v : x) v = uniform(random);
  return x;
}

double reference_dot(const std::vector<double>& x, const std::vector<double>& y) {
  long double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += static_cast<long double>(x[i]) * y[i];
  return static_cast<double>(sum);
}

// Lengths below, at and above the lanes and the pieces.
const std::size_t lengths[] = {0, 1, 7, 8, 9, 2047, 2048, 2049, 100003};

TEST(VectorOps, AgreeWithPlainLoops) {
  for (const std::size_t n : lengths) {
    const auto x = random_vector(n, 1), y = random_vector(n, 2), z = random_vector(n, 3);
    const double tolerance = 1e-13 * (1 + static_cast<double>(n));
    EXPECT_NEAR(dot(x, y), reference_dot(x, y), tolerance);
    EXPECT_NEAR(norm(x), std::sqrt(reference_dot(x, x)), tolerance);

    std::vector<double> sum(n);
    add_scaled(x, 0.25, y, sum);
    for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(sum[i], x[i] + 0.25 * y[i], 1e-15);
    std::vector<double> difference(n);
    add_scaled(x, -1, y, difference);
    EXPECT_NEAR(distance(x, y), std::sqrt(reference_dot(difference, difference)), tolerance);

    std::vector<double> moved = x;
    const double product = add_scaled_and_dot(0.25, y, moved, z);
    for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(moved[i], sum[i], 1e-15);
    EXPECT_NEAR(product, reference_dot(sum, z), tolerance);

    std::vector<double> d = y;
    const DirectionSize size = conjugate_direction(x, 0.5, d);
    for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(d[i], 0.5 * y[i] - x[i], 1e-15);
    EXPECT_NEAR(size.slope, reference_dot(x, d), tolerance);
    EXPECT_NEAR(size.length, std::sqrt(reference_dot(d, d)), tolerance);
    EXPECT_NEAR(direction_size(x, d).slope, size.slope, tolerance);

    std::vector<double> s(n), change(n);
    const PairProducts products = difference_pair(x, y, z, x, s, change);
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(s[i], y[i] - x[i]);
      ASSERT_EQ(change[i], x[i] - z[i]);
    }
    EXPECT_NEAR(products.s_y, reference_dot(s, change), tolerance);
    EXPECT_NEAR(products.s_s, reference_dot(s, s), tolerance);
    EXPECT_NEAR(products.y_y, reference_dot(change, change), tolerance);
  }
}

TEST(VectorOps, SumsDoNotDependOnThreadsOrOnWhereTheDataLie) {
  const std::size_t n = 100003;
  const auto x = random_vector(n, 1), y = random_vector(n, 2);
  set_n_threads(1);
  const double one = dot(x, y);
  set_n_threads(2);
  for (int repeat = 0; repeat < 20; ++repeat) EXPECT_EQ(dot(x, y), one);
  set_n_threads(0);
  std::vector<double> shifted_x(n + 3), shifted_y(n + 1);
  std::copy(x.begin(), x.end(), shifted_x.begin() + 3);
  std::copy(y.begin(), y.end(), shifted_y.begin() + 1);
  EXPECT_EQ(dot(std::span(shifted_x).subspan(3), std::span(shifted_y).subspan(1)), one);
}

TEST(VectorOps, ARestartForgetsInfinities) {
  const std::vector<double> g{1, 2};
  std::vector<double> d{std::numeric_limits<double>::infinity(), std::nan("")};
  conjugate_direction(g, 0, d);
  EXPECT_EQ(d, (std::vector<double>{-1, -2}));
}

}  // namespace
}  // namespace shellmatch
