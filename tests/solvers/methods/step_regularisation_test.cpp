#include "solvers/methods/step_regularisation.h"

#include "solvers/methods/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace shellmatch {
namespace {

/// |x|^2 / 2 - sum x_i in as many unknowns as regions, D_r = e_r e_r^T, and a model that is the second derivative. The
/// step leads beyond the model in some of the regions, so many times; what it is damped by is kept.
class Regions final : public SecondOrderObjective {
 public:
  explicit Regions(std::size_t n) : added(n, 0.0) {}
  std::size_t size() const override { return added.size(); }
  bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) override {
    value = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      value += 0.5 * x[i] * x[i] - x[i];
      if (!gradient.empty()) gradient[i] = x[i] - 1;
    }
    return true;
  }
  void prepare_second_derivative(std::span<const double>, std::span<const float> damping) override {
    prepared.assign(damping.begin(), damping.end());
    std::ranges::fill(added, 0.0);
    extended = false;
    std::ranges::copy(damping, added.begin());
    if (first_prepared.empty()) first_prepared = prepared;
  }
  void apply_second_derivative(std::span<const double> x, std::span<double> y) const override {
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = (1 + added[i]) * x[i];
  }
  void precondition(std::span<const double> r, std::span<double> z) const override { std::ranges::copy(r, z.begin()); }
  std::size_t n_regions() const override { return size(); }
  std::vector<RegionDamping> regions_beyond_model(std::span<const double>, std::span<const double>) override {
    ++n_asked;
    return n_beyond-- > 0 ? beyond : std::vector<RegionDamping>{};
  }
  void add_damping(std::span<const RegionDamping> regions) override {
    ++n_added;
    for (const RegionDamping& one : regions) added[one.region] += one.factor;
  }

  void contract_step(std::span<const RegionDamping> regions, double share, std::span<double> d) override {
    ++n_contracted;
    for (const RegionDamping& one : regions) d[one.region] *= share;
  }

  // x_0 beyond `bound` costs 9 (x_0 - bound)^2: the step meets it, once for each model.
  bool extend_model(std::span<const double> x, std::span<const double> d, std::span<double> gradient) override {
    if (x.empty() || extended || !(x[0] + d[0] > bound)) return false;
    extended = true;
    added[0] += 18;
    gradient[0] += 18 * (x[0] - bound);
    return true;
  }

  double bound = 1e9;
  bool extended = false;
  int n_contracted = 0;
  std::vector<RegionDamping> beyond;  ///< the regions, with their own stiffness
  int n_beyond = 0;
  int n_asked = 0, n_added = 0;
  std::vector<float> prepared, first_prepared;  ///< damping of the last model as it was prepared, and of the first
  std::vector<double> added;                    ///< the same with what was added to it since
};

/// One step of the policy: the model is prepared, and the step regularised as often as may be. Returns how often.
int one_step(StepRegularisation& policy, Regions& objective) {
  const std::vector<double> x(objective.size(), 0.0);
  std::vector<double> g(objective.size(), -1.0);
  objective.prepare_second_derivative(x, policy.next_damping());
  int n = 0;
  while (policy.regularise(objective, x, x, g)) ++n;
  return n;
}

const NewtonOptions options{.max_regularisations = 5, .regularisation_growth = 8, .regularisation_decay = 0.25};

TEST(StepRegularisation, BeginsWithTheRegionsOwnStiffness) {
  Regions objective(3);
  objective.beyond = {{1, 2.5}, {2, 100}};
  objective.n_beyond = 1;
  StepRegularisation policy(options, objective);
  EXPECT_EQ(one_step(policy, objective), 1);
  EXPECT_EQ(objective.first_prepared, (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(objective.added, (std::vector<double>{0, 2.5, 100}));
}

TEST(StepRegularisation, GrowsWhereItWasNotEnoughAndNowhereElse) {
  Regions objective(3);
  objective.beyond = {{1, 2}};
  objective.n_beyond = 3;
  StepRegularisation policy(options, objective);
  EXPECT_EQ(one_step(policy, objective), 3);
  EXPECT_EQ(objective.added, (std::vector<double>{0, 2 * 8 * 8, 0}));
  EXPECT_EQ(objective.n_asked, 4) << "also of the step that is taken";
  // A region that has become stiffer meanwhile is damped by that at least.
  objective.beyond = {{1, 1000}, {2, 3}};
  objective.n_beyond = 1;
  one_step(policy, objective);
  EXPECT_EQ(objective.added, (std::vector<double>{0, 1000, 3}));
}

TEST(StepRegularisation, FadesFromStepToStep) {
  Regions objective(2);
  objective.beyond = {{0, 64}};
  objective.n_beyond = 1;
  StepRegularisation policy(options, objective);
  one_step(policy, objective);
  for (const float factor : {16.0F, 4.0F, 1.0F}) {
    EXPECT_EQ(one_step(policy, objective), 0);
    EXPECT_EQ(objective.prepared, (std::vector<float>{factor, 0}));
  }
  // It grows from what is left of it.
  objective.beyond = {{0, 1e-3}};
  objective.n_beyond = 1;
  EXPECT_EQ(one_step(policy, objective), 1);
  EXPECT_EQ(objective.prepared[0], 0.25F);
  EXPECT_EQ(objective.added[0], 2);
}

TEST(StepRegularisation, SolvesSoManySystemsAtMostForEachStep) {
  for (const int most : {0, 1, 5}) {
    NewtonOptions o = options;
    o.max_regularisations = most;
    Regions objective(1);
    objective.beyond = {{0, 1}};
    objective.n_beyond = 1000;
    StepRegularisation policy(o, objective);
    for (int step = 0; step < 3; ++step) EXPECT_EQ(one_step(policy, objective), most) << "step " << step;
    EXPECT_EQ(objective.n_added, 3 * most);
    EXPECT_EQ(policy.n_systems(), 3 * most);
  }
}

TEST(StepRegularisation, WhatIsLeftIsHalvedInItsRegionsAndThenEverywhere) {
  NewtonOptions o = options;
  o.max_regularisations = 1;
  o.max_contractions = 3;
  const std::vector<double> x(3, 0.0), g(3, -1.0);
  const auto contracted = [&](int n_beyond, const std::vector<double>& of_g) {
    Regions objective(3);
    objective.beyond = {{1, 2}};
    objective.n_beyond = n_beyond;
    StepRegularisation policy(o, objective);
    one_step(policy, objective);
    std::vector<double> d(3, 1.0);
    policy.contract(objective, x, of_g, d);
    return d;
  };
  EXPECT_EQ(contracted(0, g), (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(contracted(1, g), (std::vector<double>{1, 1, 1})) << "the last system leads nowhere beyond";
  EXPECT_EQ(contracted(3, g), (std::vector<double>{1, 0.25, 1}));
  EXPECT_EQ(contracted(4, g), (std::vector<double>{1, 0.125, 1}));
  EXPECT_EQ(contracted(6, g), (std::vector<double>{0.25, 0.125 / 4, 0.25}));
  EXPECT_EQ(contracted(3, {1, -3, 1}), (std::vector<double>{1, 1, 1})) << "it would lead upwards";
}

TEST(StepRegularisation, AStepWithSystemsToSpareIsNotContracted) {
  Regions objective(2);
  objective.beyond = {{0, 1}};
  objective.n_beyond = 2;
  StepRegularisation policy(options, objective);
  EXPECT_EQ(one_step(policy, objective), 2);
  std::vector<double> d(2, 1.0);
  const int n_asked = objective.n_asked;
  policy.contract(objective, d, {}, d);
  EXPECT_EQ(objective.n_asked, n_asked);
  EXPECT_EQ(objective.n_contracted, 0);
}

TEST(StepRegularisation, IsRestrainedWhereAllItsSystemsWereUsed) {
  Regions objective(2);
  objective.beyond = {{0, 1}};
  StepRegularisation policy(options, objective);
  for (const int n : {0, options.max_regularisations - 1, options.max_regularisations, 0}) {
    objective.n_beyond = n;
    EXPECT_EQ(one_step(policy, objective), n);
    EXPECT_EQ(policy.is_restrained(), n == options.max_regularisations) << n;
  }
}

// What a step meets is neither damped nor kept for the next step, and the step is that of the extended model: x_0 of
// x^2 / 2 - x + 9 (x - 0.5)^2.
TEST(StepRegularisation, AnExtendedModelIsSolvedAgain) {
  Regions objective(2);
  objective.bound = 0.5;
  StepRegularisation policy(options, objective);
  const std::vector<double> x(2, 0.0), d(2, 1.0);
  std::vector<double> g(2, -1.0);
  objective.prepare_second_derivative(x, policy.next_damping());
  EXPECT_TRUE(policy.regularise(objective, x, d, g));
  EXPECT_EQ(g, (std::vector<double>{-10, -1}));
  EXPECT_FALSE(policy.regularise(objective, x, d, g));
  EXPECT_EQ(objective.n_added, 1);
  objective.prepare_second_derivative(x, policy.next_damping());
  EXPECT_EQ(objective.prepared, (std::vector<float>{0, 0}));

  std::vector<double> at(2, 0.0);
  Newton(options).minimize(objective, at, {.max_iterations = 1}, {});
  EXPECT_NEAR(at[0], 10.0 / 19, 1e-6);
  EXPECT_NEAR(at[1], 1, 1e-6);
}

TEST(StepRegularisation, AnObjectiveWithoutRegionsIsLeftAlone) {
  Regions objective(0);
  StepRegularisation policy(options, objective);
  EXPECT_TRUE(policy.next_damping().empty());
  EXPECT_EQ(one_step(policy, objective), 0);
}

// As the options of a level say, and the step is that of the damped model: 1 / (1 + 3) instead of 1.
TEST(StepRegularisation, NewtonTakesTheRegularisedStepAndForgetsItInTheEnd) {
  const Newton newton({.max_forcing = 1e-12, .min_forcing = 1e-12});
  StopOptions stop;
  stop.max_iterations = 1;
  stop.relative_decrease = 0;
  for (int minimisation = 0; minimisation < 2; ++minimisation) {
    Regions objective(2);
    objective.beyond = {{1, 3}};
    objective.n_beyond = 1;
    std::vector<double> x(2, 0.0);
    newton.minimize(objective, x, stop);
    EXPECT_EQ(objective.first_prepared, (std::vector<float>{0, 0})) << "minimisation " << minimisation;
    EXPECT_NEAR(x[0], 1, 1e-9);
    EXPECT_NEAR(x[1], 0.25, 1e-9);
    // The same objective again: nothing is left of the damping.
    x = {0, 0};
    objective.first_prepared.clear();
    newton.minimize(objective, x, stop);
    EXPECT_EQ(objective.first_prepared, (std::vector<float>{0, 0}));
    EXPECT_NEAR(x[1], 1, 1e-9);
  }
}

}  // namespace
}  // namespace shellmatch
