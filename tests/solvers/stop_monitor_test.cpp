#include "solvers/minimization_run.h"

#include <gtest/gtest.h>

#include <thread>

namespace shellmatch {
namespace {

IterationRecord record(int iteration, double value, double gradient_norm) {
  IterationRecord r;
  r.iteration = iteration;
  r.value = value;
  r.gradient_norm = gradient_norm;
  return r;
}

TEST(StopMonitor, MeasuresTheDecreaseOverTheWindow) {
  StopMonitor monitor({.max_iterations = 100, .relative_decrease = 0.1, .decrease_window = 3, .gradient_norm = 0});
  // Falls by 4 % per step: over three steps by 11.5 %, which goes on; then by 1 % per step.
  double value = 100;
  for (int k = 0; k < 10; ++k, value *= 0.96) EXPECT_EQ(monitor.check(record(k, value, 1)), std::nullopt) << k;
  value /= 0.96;
  value *= 0.99;  // 9.1 % over the last three steps
  EXPECT_EQ(monitor.check(record(10, value, 1)), StopReason::relative_decrease);
}

// 2 % are enough after a step that went its own way, but not after a restrained one.
TEST(StopMonitor, AsksMoreOfRestrainedSteps) {
  const StopOptions rules{.relative_decrease = 0.01, .decrease_window = 1, .restrained_factor = 3, .gradient_norm = 0};
  for (const bool restrained : {false, true}) {
    StopMonitor monitor(rules);
    EXPECT_EQ(monitor.check(record(0, 100, 1)), std::nullopt);
    IterationRecord next = record(1, 98, 1);
    next.restrained = restrained;
    const auto reason = monitor.check(next);
    EXPECT_EQ(reason.has_value(), restrained);
    if (reason) {
      EXPECT_EQ(monitor.message(*reason), "the value fell by less than 0.03 of itself over 1 iterations");
    }
  }
}

// Three small gains in a row end it, or one of a whole step.
TEST(StopMonitor, TakesNoShortenedStepForTheEnd) {
  const StopOptions rules{.relative_decrease = 0.01, .decrease_window = 1, .gradient_norm = 0};
  const auto checked = [&](std::vector<std::pair<double, bool>> steps) {
    StopMonitor monitor(rules);
    std::optional<StopReason> reason = monitor.check(record(0, 100, 1));
    for (std::size_t k = 0; k < steps.size(); ++k) {
      EXPECT_EQ(reason, std::nullopt) << k;
      IterationRecord next = record(static_cast<int>(k) + 1, steps[k].first, 1);
      next.shortened = steps[k].second;
      reason = monitor.check(next);
    }
    return reason;
  };
  EXPECT_EQ(checked({{99.9, false}}), StopReason::relative_decrease);
  EXPECT_EQ(checked({{99.9, true}, {99.8, true}}), std::nullopt);
  EXPECT_EQ(checked({{99.9, true}, {99.8, true}, {99.7, true}}), StopReason::relative_decrease);
  EXPECT_EQ(checked({{99.9, true}, {99.8, true}, {90, true}, {89.9, true}, {89.8, true}}), std::nullopt);
}

TEST(StopMonitor, IsNotFooledByASlowStartOfTheWindow) {
  StopMonitor monitor({.max_iterations = 100, .relative_decrease = 0.1, .decrease_window = 3, .gradient_norm = 0});
  for (int k = 0; k < 3; ++k) EXPECT_EQ(monitor.check(record(k, 100, 1)), std::nullopt) << k;  // window not full yet
  EXPECT_EQ(monitor.check(record(3, 80, 1)), std::nullopt);
}

TEST(StopMonitor, ComparesTheGradientWithItsFirstValue) {
  StopMonitor monitor({.max_iterations = 100, .relative_decrease = 0, .decrease_window = 3, .gradient_norm = 0.01});
  EXPECT_EQ(monitor.check(record(0, 1, 50)), std::nullopt);
  EXPECT_EQ(monitor.check(record(1, 1, 0.51)), std::nullopt);
  EXPECT_EQ(monitor.check(record(2, 1, 0.5)), StopReason::gradient_norm);
}

TEST(StopMonitor, CountsIterationsAndSeconds) {
  StopMonitor counted({.max_iterations = 2, .relative_decrease = 0});
  EXPECT_EQ(counted.check(record(0, 1, 1)), std::nullopt);
  EXPECT_EQ(counted.check(record(1, 1, 1)), std::nullopt);
  EXPECT_EQ(counted.check(record(2, 1, 1)), StopReason::max_iterations);
  StopMonitor timed({.relative_decrease = 0, .max_seconds = 0.01});
  EXPECT_EQ(timed.check(record(0, 1, 1)), std::nullopt);
  std::this_thread::sleep_for(std::chrono::milliseconds(12));
  EXPECT_EQ(timed.check(record(1, 1, 1)), StopReason::max_seconds);
}

TEST(StopMonitor, NamesTheRuleWithItsNumber) {
  StopMonitor monitor({.max_iterations = 123, .relative_decrease = 0.25, .decrease_window = 7});
  EXPECT_NE(monitor.message(StopReason::max_iterations).find("123"), std::string::npos);
  EXPECT_NE(monitor.message(StopReason::relative_decrease).find("0.25"), std::string::npos);
}

TEST(StopMonitor, AWindowOfZeroIsOneAndIsCalledSo) {
  StopMonitor monitor({.max_iterations = 100, .relative_decrease = 0.1, .decrease_window = 0, .gradient_norm = 0});
  EXPECT_EQ(monitor.check(record(0, 100, 1)), std::nullopt);
  EXPECT_EQ(monitor.check(record(1, 95, 1)), StopReason::relative_decrease);
  EXPECT_EQ(monitor.message(StopReason::relative_decrease),
            "the value fell by less than 0.1 of itself over 1 iterations");
}

}  // namespace
}  // namespace shellmatch
