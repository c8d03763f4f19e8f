#include "solvers/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
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
  void prepare_second_derivative(std::span<const double>) override { products.push_back(0); }
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

}  // namespace
}  // namespace shellmatch
