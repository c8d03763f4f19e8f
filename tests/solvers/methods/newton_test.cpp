#include "solvers/methods/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shellmatch {
namespace {

/// sum i x_i^2 / 2, whose model says `factor` times as much. Counts products with the model.
class Bowl final : public SecondOrderObjective {
 public:
  explicit Bowl(double factor) : factor_(factor) {}
  std::size_t size() const override { return 200; }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    value = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double stiffness = static_cast<double>(i + 1);
      value += 0.5 * stiffness * x[i] * x[i];
      if (!gradient.empty()) gradient[i] = stiffness * x[i];
    }
    return true;
  }
  void prepare_second_derivative(std::span<const double>, std::span<const float>) override { products.push_back(0); }
  void apply_second_derivative(std::span<const double> x, std::span<double> y) const override {
    ++products.back();
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = factor_ * static_cast<double>(i + 1) * x[i];
  }
  void precondition(std::span<const double> r, std::span<double> z) const override { std::ranges::copy(r, z.begin()); }

  mutable std::vector<int> products;  ///< in each step

 private:
  double factor_;
};

/// Products in each of some steps.
std::vector<int> products(double factor, double min_forcing, double max_forcing) {
  Bowl bowl(factor);
  std::vector<double> x(bowl.size(), 1.0);
  StopOptions stop;
  stop.max_iterations = 4;
  stop.relative_decrease = 0;
  Newton({.max_forcing = max_forcing, .min_forcing = min_forcing}).minimize(bowl, x, stop);
  return bowl.products;
}

// The model that says four times too much leaves three quarters of the gradient: nothing is gained by solving its
// systems well.
TEST(Newton, SolvesSystemsAsWellAsTheModelPredicts) {
  const auto well = products(4, 0.01, 0.01), between = products(4, 0.01, 0.9);
  ASSERT_EQ(well.size(), 4u);
  ASSERT_EQ(between.size(), 4u);
  EXPECT_EQ(between[0], well[0]) << "nothing is known before the first step";
  for (std::size_t step = 1; step < 4; ++step) EXPECT_LT(between[step], well[step] / 2);
  // A model that is right predicts what is left of the gradient.
  EXPECT_EQ(products(1, 0.1, 0.9), products(1, 0.1, 0.1));
  // The larger of the two is never exceeded, whatever the smaller is.
  EXPECT_EQ(products(4, 0.5, 0.01), products(4, 0.01, 0.01));
}

/// sum exp(x_i) - x_i: its model is exact, but other at every point.
class Exponentials final : public SecondOrderObjective {
 public:
  std::size_t size() const override { return 3; }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    value = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      value += std::exp(x[i]) - x[i];
      if (!gradient.empty()) gradient[i] = std::exp(x[i]) - 1;
    }
    return true;
  }
  void prepare_second_derivative(std::span<const double> x, std::span<const float>) override {
    ++n_models;
    at_.assign(x.begin(), x.end());
  }
  void apply_second_derivative(std::span<const double> x, std::span<double> y) const override {
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = std::exp(at_[i]) * x[i];
  }
  void precondition(std::span<const double> r, std::span<double> z) const override {
    for (std::size_t i = 0; i < r.size(); ++i) z[i] = r[i] / std::exp(at_[i]);
  }
  int n_models = 0;

 private:
  std::vector<double> at_;
};

struct Outcome {
  int n_models, n_steps;
  double value;
};

Outcome minimised(double reuse_below, double start, double relative_decrease) {
  Exponentials objective;
  std::vector<double> x(objective.size(), start);
  StopOptions stop;
  stop.relative_decrease = relative_decrease;
  stop.decrease_window = 1;
  const MinimizerSummary summary =
      Newton({.max_forcing = 1e-9, .min_forcing = 1e-9, .reuse_below = reuse_below}).minimize(objective, x, stop);
  return {objective.n_models, summary.iterations, summary.final_value};
}

// From 0.1 the first step gains 1.5e-2, all but 1e-5 of what there is.
TEST(Newton, AStepThatGainsLittleHasTheModelOfTheOneBefore) {
  const Outcome own = minimised(0, 0.1, 1e-3), reused = minimised(0.25, 0.1, 1e-3);
  EXPECT_EQ(own.n_models, own.n_steps);
  EXPECT_EQ(reused.n_steps, own.n_steps);
  EXPECT_EQ(reused.n_models, own.n_models - 1);
  EXPECT_NEAR(reused.value, 3, 1e-6) << "the old model still leads on";
  EXPECT_LT(own.value, reused.value);
  // A model serves two steps at most, however small the gains.
  const Outcome accurate = minimised(1, 0.1, 1e-12);
  EXPECT_GE(2 * accurate.n_models, accurate.n_steps);
  EXPECT_NEAR(accurate.value, 3, 1e-14);
  // Far away the gain is not what the model says: every step but the last few has its own.
  const Outcome far = minimised(1, 6, 1e-2);
  EXPECT_GE(far.n_models, far.n_steps - 1);
}

/// A quadratic function of three unknowns. Its one region is damped along one direction, after the first step of all.
class Stiffened final : public SecondOrderObjective {
 public:
  explicit Stiffened(double stiffness) : stiffness_(stiffness) {}
  std::size_t size() const override { return 3; }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    value = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      value += (slope[i] + 0.5 * curvature[i] * x[i]) * x[i];
      if (!gradient.empty()) gradient[i] = slope[i] + curvature[i] * x[i];
    }
    return true;
  }
  void prepare_second_derivative(std::span<const double>, std::span<const float>) override { added_ = 0; }
  void apply_second_derivative(std::span<const double> x, std::span<double> y) const override {
    ++n_products;
    double along = 0;
    for (std::size_t i = 0; i < 3; ++i) along += direction[i] * x[i];
    for (std::size_t i = 0; i < 3; ++i) y[i] = curvature[i] * x[i] + added_ * along * direction[i];
  }
  void precondition(std::span<const double> r, std::span<double> z) const override { std::ranges::copy(r, z.begin()); }
  std::size_t n_regions() const override { return 1; }
  std::vector<RegionDamping> regions_beyond_model(std::span<const double>, std::span<const double> d) override {
    if (added_ > 0) {
      regularised_step.assign(d.begin(), d.end());
      return {};
    }
    n_products_before = n_products;
    return {{0, stiffness_}};
  }
  void add_damping(std::span<const RegionDamping> regions) override { added_ += regions[0].factor; }

  static constexpr std::array<double, 3> slope{0, 3, 8}, curvature{100, 1, 10}, direction{-1, 3, 1};
  mutable int n_products = 0;
  int n_products_before = 0;
  std::vector<double> regularised_step;

 private:
  double stiffness_, added_ = 0;
};

MinimizerSummary one_step(Stiffened& objective, const NewtonOptions& options) {
  std::vector<double> x(3, 0.0);
  StopOptions stop;
  stop.max_iterations = 1;
  stop.relative_decrease = 0;
  return Newton(options).minimize(objective, x, stop);
}

// What the step solves in the end is the stiffened system; nothing is done where next to nothing has changed.
TEST(Newton, GoesOnFromAStepThatWasRegularised) {
  Stiffened little(1e-6), much(50);
  const MinimizerSummary summary = one_step(little, {.max_forcing = 1e-4, .min_forcing = 1e-4});
  EXPECT_EQ(little.n_products_before, 2) << "the slope has two components";
  EXPECT_EQ(summary.linear_iterations, 2);
  EXPECT_EQ(summary.regularised_systems, 1);
  EXPECT_EQ(little.n_products - little.n_products_before, 1) << "with the step itself";
  one_step(much, {.max_forcing = 1e-9, .min_forcing = 1e-9});
  ASSERT_EQ(much.regularised_step.size(), 3u);
  std::vector<double> residual(3);
  much.apply_second_derivative(much.regularised_step, residual);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(residual[i], -Stiffened::slope[i], 1e-6);
}

// With so few iterations, found by trial, going on from the step as it was would lead upwards.
TEST(Newton, DescendsAfterRegularisationThoughIterationsAreFew) {
  Stiffened objective(1e4);
  const MinimizerSummary summary =
      one_step(objective, {.max_forcing = 1e-9, .min_forcing = 1e-9, .max_linear_iterations = 2});
  double slope = 0;
  for (std::size_t i = 0; i < 3; ++i) slope += Stiffened::slope[i] * objective.regularised_step[i];
  EXPECT_LT(slope, 0);
  EXPECT_EQ(summary.iterations, 1);
  EXPECT_LT(summary.final_value, 0);
}

}  // namespace
}  // namespace shellmatch
