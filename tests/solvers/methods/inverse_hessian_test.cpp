// What makes a quasi-Newton matrix one, and what conjugate directions are for.
#include "solvers/methods/lbfgs.h"

#include "solvers/solver_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace shellmatch {
namespace {

// A quadratic with eigenvalues from 1 to `condition`, in an arbitrary position of its axes to each other.
struct Quadratic final : Objective {
  Quadratic(std::size_t n, double condition) : eigenvalues(n) {
    for (std::size_t i = 0; i < n; ++i)
      eigenvalues[i] = std::pow(condition, static_cast<double>(i) / static_cast<double>(n - 1));
  }
  std::vector<double> eigenvalues;
  std::size_t size() const override { return eigenvalues.size(); }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    value = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      value += 0.5 * eigenvalues[i] * x[i] * x[i];
      if (!gradient.empty()) gradient[i] = eigenvalues[i] * x[i];
    }
    return true;
  }
};

class InverseHessian : public ::testing::Test {
 protected:
  // Fills H with random steps of the quadratic, more than it holds.
  void SetUp() override {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const auto sample = [&] {
      std::vector<double> v(n);
      for (double& e : v) e = normal(random);
      return v;
    };
    const auto times_eigenvalues = [&](std::vector<double> v) {
      for (std::size_t i = 0; i < n; ++i) v[i] *= quadratic.eigenvalues[i];
      return v;
    };
    for (int k = 0; k < 9; ++k) {
      const auto x0 = sample(), x1 = sample(), g0 = times_eigenvalues(x0), g1 = times_eigenvalues(x1);
      ASSERT_TRUE(h.add(x0, x1, g0, g1));
      for (std::size_t i = 0; i < n; ++i) {
        s[i] = x1[i] - x0[i];
        y[i] = g1[i] - g0[i];
      }
    }
    a = sample();
    b = sample();
  }
  std::vector<double> times(const std::vector<double>& v) {
    std::vector<double> d(n);
    h.descend(v, d);
    for (double& e : d) e = -e;
    return d;
  }
  static double product(const std::vector<double>& u, const std::vector<double>& v) {
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) sum += u[i] * v[i];
    return sum;
  }
  static constexpr std::size_t n = 30;
  Quadratic quadratic{n, 100};
  LimitedMemoryInverseHessian h{n, 5, 1e-8};
  std::vector<double> s = std::vector<double>(n), y = std::vector<double>(n), a, b;
};

TEST_F(InverseHessian, SatisfiesTheSecantEquationOfTheNewestStep) {
  const auto hy = times(y);
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(hy[i], s[i], 1e-12);
  EXPECT_EQ(h.count(), 5u);
}

TEST_F(InverseHessian, IsSymmetricAndPositiveDefinite) {
  const double ab = product(a, times(b)), ba = product(b, times(a));
  EXPECT_NEAR(ab, ba, 1e-12 * (std::abs(ab) + 1));
  EXPECT_GT(product(a, times(a)), 0);
  EXPECT_GT(product(b, times(b)), 0);
}

// (7.19) with one pair, written out: V^T gamma V + rho s s^T.
TEST_F(InverseHessian, IsTheBfgsMatrixOfOnePair) {
  LimitedMemoryInverseHessian one(n, 5, 1e-8);
  const std::vector<double> zero(n, 0.0);
  ASSERT_TRUE(one.add(zero, s, zero, y));
  std::vector<double> d(n);
  one.descend(a, d);
  const double rho = 1 / product(s, y), gamma = product(s, y) / product(y, y), sa = product(s, a);
  std::vector<double> va(n);
  for (std::size_t i = 0; i < n; ++i) va[i] = gamma * (a[i] - rho * sa * y[i]);
  const double yva = product(y, va);
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(d[i], -(va[i] - rho * yva * s[i] + rho * sa * s[i]), 1e-12);
}

TEST_F(InverseHessian, RefusesAPairWithoutPositiveCurvature) {
  const std::vector<double> zero(n, 0.0);
  std::vector<double> minus_y = y;
  for (double& e : minus_y) e = -e;
  EXPECT_FALSE(h.add(zero, s, zero, minus_y));
  EXPECT_EQ(h.count(), 4u);
  EXPECT_GT(product(a, times(a)), 0);
  const auto hy = times(y);  // the newest good pair is still the newest
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(hy[i], s[i], 1e-12);
}

// Conjugate directions need about root(condition) steps where the steepest descent needs the condition
// itself.
TEST(IllConditionedQuadratic, IsSolvedInAboutTheRootOfItsConditionSteps) {
  for (const std::string name : {"fletcher_reeves", "lbfgs"}) {
    SolverOptions options;
    options.name = name;
    options.stop = {.max_iterations = 50000,
                    .relative_decrease = 0,
                    .decrease_window = 10,
                    .gradient_norm = 1e-6,
                    .max_seconds = 0};
    options.fletcher_reeves.least_cosine = 0;
    options.fletcher_reeves.curvature = 0.1;
    Quadratic quadratic(300, 1e4);
    std::vector<double> x(300, 1.0);
    const auto summary = make_minimizer(options)->minimize(quadratic, x, options.stop);
    EXPECT_EQ(summary.reason, StopReason::gradient_norm) << name << ": " << summary.message;
    EXPECT_LT(summary.iterations, 1200) << name;
    RecordProperty(name, summary.iterations);
    std::vector<double> z(300, 1.0);
    options.fletcher_reeves.restart_every = 1;  // the steepest descent
    options.name = "fletcher_reeves";
    EXPECT_GT(make_minimizer(options)->minimize(quadratic, z, options.stop).iterations, 2 * summary.iterations);
  }
}

}  // namespace
}  // namespace shellmatch
