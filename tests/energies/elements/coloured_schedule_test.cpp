#include "energies/elements/coloured_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace shellmatch {
namespace {

/// Task i accesses data i, 2 i and 3 i modulo 50.
std::vector<Index> data_of(std::size_t i) {
  std::vector<Index> data;
  for (const std::size_t factor : {1, 2, 3}) data.push_back(static_cast<Index>(factor * i % 50));
  return data;
}
constexpr std::size_t n_tasks = 200;

TEST(ColouredSchedule, HoldsEveryTaskOnceWithTheLastOnesThatAccessItsData) {
  const ColouredSchedule schedule(n_tasks, 50, data_of);
  std::vector<std::size_t> order(schedule.tasks().begin(), schedule.tasks().end()), all(n_tasks);
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::sort(order);
  EXPECT_EQ(order, all);
  std::vector<Index> last(50, -1);
  for (std::size_t k = 0; k < n_tasks; ++k) {
    std::set<Index> expected;
    for (const Index i : data_of(schedule.tasks()[k])) expected.insert(std::exchange(last[i], static_cast<Index>(k)));
    expected.erase(-1);
    expected.erase(static_cast<Index>(k));  // where 2 i is i
    EXPECT_TRUE(std::ranges::equal(schedule.predecessors_of(k), expected)) << "task " << schedule.tasks()[k];
  }
}

// Tasks that access the same data are far apart in the order, so that threads seldom wait: greedy colouring of a
// chain needs two colours.
TEST(ColouredSchedule, SortsTasksByColour) {
  const ColouredSchedule chain(100, 101, [](std::size_t i) {
    return std::array{static_cast<Index>(i), static_cast<Index>(i + 1)};
  });
  for (std::size_t k = 0; k < 100; ++k) EXPECT_EQ(chain.tasks()[k], k < 50 ? 2 * k : 2 * (k - 50) + 1);
}

TEST(ColouredSchedule, RunsTasksWithCommonDataOneAfterTheOtherInItsOrder) {
  set_n_threads(4);
  const ColouredSchedule schedule(n_tasks, 50, data_of);
  std::vector<std::atomic<int>> n_running(50);
  std::vector<std::vector<std::size_t>> visits(50), expected(50);
  for (const std::size_t task : schedule.tasks())
    for (const Index i : data_of(task)) expected[i].push_back(task);
  schedule.run([&](std::size_t task) {
    for (const Index i : data_of(task)) {
      const std::size_t repeated = std::ranges::count(data_of(task), i);
      EXPECT_LE(n_running[i]++, static_cast<int>(repeated) - 1) << "task " << task;
      visits[i].push_back(task);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(task % 7 * 50));
    for (const Index i : data_of(task)) --n_running[i];
  });
  EXPECT_EQ(visits, expected);
  set_n_threads(0);
}

TEST(ColouredSchedule, EndsWithTheFirstExceptionAndLeavesNoThreadWaiting) {
  set_n_threads(4);
  const ColouredSchedule schedule(n_tasks, 50, data_of);
  std::atomic<int> n_done = 0;
  EXPECT_THROW(schedule.run([&](std::size_t task) {
    if (task == schedule.tasks()[20]) throw std::runtime_error("it fails");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // time for the other threads to join in
    ++n_done;
  }),
               std::runtime_error);
  EXPECT_GE(n_done, 1);
  EXPECT_LT(n_done, 150);
  set_n_threads(0);
}

// All tasks access the same datum, and there are more of them than colours in one pass.
TEST(ColouredSchedule, UsesAsManyColoursAsItTakes) {
  const ColouredSchedule schedule(150, 1, [](std::size_t) { return std::array{Index{0}}; });
  ASSERT_EQ(schedule.tasks().size(), 150u);
  for (std::size_t k = 1; k < 150; ++k)
    EXPECT_TRUE(std::ranges::equal(schedule.predecessors_of(k), std::array{static_cast<Index>(k - 1)}));
}

}  // namespace
}  // namespace shellmatch
