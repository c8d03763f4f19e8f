// The metric is a change of variables: what it promises, and that every method reaches the same minimum in
// it.
#include "solvers/metric/metric.h"

#include "base/error.h"
#include "solvers/metric/cholmod_factor.h"
#include "tests/support/test_problems.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>

namespace shellmatch {
namespace {

TEST(Metric, GradientNormIsThatOfTheL2Gradient) {
  const auto problem = testing::weighted_bowl(12);
  const auto factor = make_metric_factor(Metric::l2, *problem);
  ASSERT_NE(factor, nullptr);
  MetricObjective in_metric(*problem, *factor);
  std::vector<double> x(12), y(12), gx(12), gy(12);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = 0.1 * static_cast<double>(i);
  factor->apply(x, y);
  double fx = 0, fy = 0;
  ASSERT_TRUE(problem->evaluate(x, fx, gx));
  ASSERT_TRUE(in_metric.evaluate(y, fy, gy));
  EXPECT_NEAR(fx, fy, 1e-14 * fx);
  // L2 gradient r = D^-1 g, and its L2 norm r.D r
  double expected = 0, actual = 0;
  const auto mass = problem->lumped_mass();
  for (std::size_t i = 0; i < x.size(); ++i) {
    expected += gx[i] * gx[i] / mass[i];
    actual += gy[i] * gy[i];
  }
  EXPECT_NEAR(actual, expected, 1e-13 * expected);
}

TEST(Metric, SteepestDescentFollowsTheL2Gradient) {
  // In y the bowl's second derivative is (1 + 3 e^2) for every unknown, whatever its mass: from a start that
  // is equally far everywhere, coordinates of equal error stay equal under any mass. In the Euclidean metric
  // not.
  struct Equal final : Objective {
    std::vector<double> mass{1, 1e-3, 1e-6};
    std::size_t size() const override { return 3; }
    bool evaluate(std::span<const double> x, double& value, std::span<double> g) override {
      value = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        value += mass[i] * (x[i] * x[i] / 2 + std::pow(x[i], 4) / 4);
        if (!g.empty()) g[i] = mass[i] * (x[i] + std::pow(x[i], 3));
      }
      return true;
    }
    std::span<const double> lumped_mass() const override { return mass; }
  } equal;
  const auto run = [&](Metric metric) {
    SolverOptions options;
    options.stop = {
        .max_iterations = 3, .relative_decrease = 0, .decrease_window = 10, .gradient_norm = 0, .max_seconds = 0};
    std::vector<double> x(3, 1.0);
    minimize_in_metric(*make_minimizer(options), metric, equal, x, options.stop);
    return x;
  };
  const auto l2 = run(Metric::l2), euclidean = run(Metric::euclidean);
  EXPECT_LT(l2[0], 0.999);
  EXPECT_NEAR(l2[0], l2[2], 1e-12);
  EXPECT_GT(euclidean[2], 0.9999);
}

TEST(Metric, ComesBackBitByBitWhereNothingWasGained) {
  const auto problem = testing::weighted_bowl(12);
  std::vector<double> x(12);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = 0.37 + 0.1 * static_cast<double>(i);
  const std::vector<double> before = x;
  const StopOptions stop{.max_iterations = 0};
  minimize_in_metric(*make_minimizer({}), Metric::l2, *problem, x, stop);
  EXPECT_EQ(x, before);
}

TEST(Metric, StepAndGradientOfTheRecordAreThoseOfTheMetric) {
  const auto problem = testing::weighted_bowl(12);
  std::vector<double> x = problem->start();
  const std::vector<double> before = x;
  const auto mass = problem->lumped_mass();
  IterationRecord last;
  const StopOptions stop{.max_iterations = 1};
  minimize_in_metric(*make_minimizer({}), Metric::l2, *problem, x, stop, [&](const IterationRecord& r) {
    last = r;
    return true;
  });
  double squared = 0;
  for (std::size_t i = 0; i < x.size(); ++i) squared += mass[i] * (x[i] - before[i]) * (x[i] - before[i]);
  EXPECT_NEAR(last.step, std::sqrt(squared), 1e-12 * last.step);
}

TEST(Metric, RefusesAMassThatIsNotPositive) {
  const std::vector<double> bad{1, 0, 1};
  EXPECT_THROW(DiagonalFactor{bad}, InputError);
  const std::vector<double> nan{1, std::nan(""), 1};
  EXPECT_THROW(DiagonalFactor{nan}, InputError);
}

std::vector<double> some_vector(std::size_t n, double phase) {
  std::vector<double> v(n);
  for (std::size_t i = 0; i < n; ++i) v[i] = std::sin(phase + 1.7 * static_cast<double>(i));
  return v;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Every component apart: y = M x.
std::vector<double> times(const Eigen::SparseMatrix<double>& m, int n_components, const std::vector<double>& x) {
  std::vector<double> y(x.size(), 0.0);
  for (int j = 0; j < m.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator e(m, j); e; ++e)
      for (int k = 0; k < n_components; ++k)
        y[static_cast<std::size_t>(e.row() * n_components + k)] +=
            e.value() * x[static_cast<std::size_t>(j * n_components + k)];
  return y;
}

TEST(SparseFactor, CarriesTheInnerProductOfItsMatrix) {
  const auto problem = testing::weighted_bowl(60);
  for (const Metric metric : {Metric::h1, Metric::weighted_h1}) {
    const Eigen::SparseMatrix<double> m = problem->metric_matrix(metric);
    const SparseFactor factor(m, 3);
    ASSERT_EQ(factor.size(), 60u);
    const auto u = some_vector(60, 0), v = some_vector(60, 2);
    std::vector<double> fu(60), fv(60), back(60), ft(60);
    factor.apply(u, fu);
    factor.apply(v, fv);
    EXPECT_NEAR(product(fu, fv), product(u, times(m, 3, v)), 1e-12 * product(fu, fu)) << enum_name(metric);
    factor.solve(fu, back);
    for (std::size_t i = 0; i < 60; ++i) EXPECT_NEAR(back[i], u[i], 1e-13);
    // <F^-T v, F u> = <v, u>; and F^-T in place
    ft = v;
    factor.solve_transposed(ft, ft);
    EXPECT_NEAR(product(ft, fu), product(v, u), 1e-12);
  }
}

TEST(SparseFactor, RefusesAMatrixThatIsNotPositiveDefinite) {
  Eigen::SparseMatrix<double> m(3, 3);
  m.insert(0, 0) = 1;
  m.insert(1, 1) = -1;
  m.insert(2, 2) = 1;
  EXPECT_THROW(SparseFactor(m, 1), InputError);
  m.coeffRef(1, 1) = 0;
  EXPECT_THROW(SparseFactor(m, 2), InputError);
}

TEST(Metric, GradientNormIsThatOfTheMetricAndThatOfL2StandsBesideIt) {
  const auto problem = testing::weighted_bowl(12);
  const std::vector<double> start = some_vector(12, 1);
  std::vector<double> g(12);
  double value = 0;
  ASSERT_TRUE(problem->evaluate(start, value, g));
  double l2 = 0;
  for (std::size_t i = 0; i < 12; ++i) l2 += g[i] * g[i] / problem->lumped_mass()[i];
  for (const std::string name : {"fletcher_reeves", "lbfgs", "ceres_lbfgs", "nlopt_lbfgs"})
    for (const auto& [metric, metric_name] : EnumNames<Metric>::names) {
      SolverOptions options;
      options.name = name;
      std::vector<double> x = start;
      std::vector<IterationRecord> records;
      const StopOptions stop{.max_iterations = 4, .relative_decrease = 0, .gradient_norm = 0};
      minimize_in_metric(*make_minimizer(options), metric, *problem, x, stop, [&](const IterationRecord& r) {
        records.push_back(r);
        return true;
      });
      EXPECT_NEAR(records[0].l2_gradient_norm, std::sqrt(l2), 1e-12 * std::sqrt(l2)) << name << metric_name;
      // g.M^-1 g, by a dense solver
      Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> rows(g.data(), 4, 3);
      double squared = product(g, g);
      if (metric == Metric::l2) squared = l2;
      if (metric == Metric::h1 || metric == Metric::weighted_h1) {
        const Eigen::MatrixXd dense = problem->metric_matrix(metric);
        squared = (rows.transpose() * dense.inverse() * rows).trace();
      }
      EXPECT_NEAR(records[0].gradient_norm, std::sqrt(squared), 1e-12 * std::sqrt(squared)) << name << metric_name;
      // At the end too: the point that came back has the gradient that the last record states.
      std::vector<double> at_end(12);
      ASSERT_TRUE(problem->evaluate(x, value, at_end));
      EXPECT_NEAR(records.back().l2_gradient_norm, problem->l2_gradient_norm(at_end),
                  1e-7 * records[0].l2_gradient_norm)
          << name << metric_name;
    }
}

class InEveryMetric : public ::testing::TestWithParam<std::string> {};

TEST_P(InEveryMetric, TheSameMinimumIsReached) {
  for (const auto& [metric, metric_name] : EnumNames<Metric>::names) {
    SolverOptions options;
    options.name = GetParam();
    options.ceres = testing::without_tolerances();
    options.metric = metric;
    options.stop = {.max_iterations = 20000,
                    .relative_decrease = 0,
                    .decrease_window = 10,
                    .gradient_norm = 1e-8,
                    .max_seconds = 20};
    const auto problem = testing::weighted_bowl(18);
    std::vector<double> x = problem->start();
    const auto minimizer = make_minimizer(options);
    const auto summary = minimize_in_metric(*minimizer, minimizer->uses_metric() ? metric : Metric::euclidean, *problem,
                                            x, options.stop);
    // The lightest unknowns weigh 8^-5: without the mass their coordinates are known less well. The chains of h1 know
    // nothing of the masses, and Ceres' methods without memory creep there.
    const bool creeps = (options.name == "ceres_steepest_descent" || options.name == "ceres_ncg") &&
                        (metric == Metric::h1 || metric == Metric::weighted_h1);
    const std::string wrong = creeps ? (summary.final_value < 1e-6 ? "" : "the value is above 1e-6")
                                     : problem->check(summary.final_value, x, 1e-10);
    EXPECT_EQ(wrong, "") << options.name << ", " << metric_name << ": " << summary.message << ", "
                         << summary.iterations;
  }
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Methods, InEveryMetric, ::testing::ValuesIn(minimizer_names()), test_name);

}  // namespace
}  // namespace shellmatch
