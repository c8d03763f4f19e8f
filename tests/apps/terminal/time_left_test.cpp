#include "apps/terminal/time_left.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

TEST(TimeLeft, KnowsNothingOnTheFirstLevel) {
  TimeLeft left(7);
  left.started(3, 1, 3, 100, 0);
  EXPECT_FALSE(left.at(5));
}

// Levels of 100 and 200 nodes at 0.1 s per node: 20 s for the second, then 40 s and 80 s.
TEST(TimeLeft, GrowsWithTheNodes) {
  TimeLeft left(6);
  left.started(3, 1, 1, 100, 1000);
  left.started(4, 1, 1, 200, 1010);
  ASSERT_TRUE(left.at(1010));
  EXPECT_DOUBLE_EQ(*left.at(1010), 20 + 40 + 80);
  EXPECT_DOUBLE_EQ(*left.at(1015), 15 + 40 + 80);
}

TEST(TimeLeft, SubstepsBelongToOneLevel) {
  TimeLeft left(4);
  left.started(3, 1, 2, 100, 0);
  left.started(3, 2, 2, 100, 6);
  left.started(4, 1, 2, 200, 10);
  EXPECT_DOUBLE_EQ(*left.at(10), 20);
}

// Foreseen 20 s, but 30 s are gone in the first of two steps, which counts as half done: 120 s in all.
TEST(TimeLeft, LearnsThatALevelTakesLonger) {
  TimeLeft left(4);
  left.started(3, 1, 1, 100, 0);
  left.started(4, 1, 2, 200, 10);
  EXPECT_DOUBLE_EQ(*left.at(40), 90);
}

TEST(TimeLeft, InWords) {
  EXPECT_EQ(time_left_text(0), "about 1 s left");
  EXPECT_EQ(time_left_text(42.3), "about 42 s left");
  EXPECT_EQ(time_left_text(200), "about 3 min left");
  EXPECT_EQ(time_left_text(2.2 * 3600), "about 2 h 12 min left");
}

}  // namespace
}  // namespace shellmatch
