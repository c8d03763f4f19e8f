#include "base/stop.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

struct NoQuestion {
  ~NoQuestion() { stop_loops_when(nullptr); }
};

TEST(Activity, IsTheLastThatWasBegun) {
  EXPECT_FALSE(last_activity());
  {
    Activity outer("outer", 10);
    outer.done(4);
    {
      const Activity inner("inner");
      EXPECT_EQ(last_activity()->name, "inner");
      EXPECT_DOUBLE_EQ(last_activity()->share, 0.4);
    }
    EXPECT_EQ(last_activity()->name, "outer");
    EXPECT_DOUBLE_EQ(last_activity()->share, 0.4);
  }
  EXPECT_FALSE(last_activity());
}

TEST(Activity, TellsOfTheOutermostHowMuchIsDone) {
  Activity outer("outer", 8);
  outer.next(2);
  EXPECT_EQ(last_activity()->share, 0);
  outer.next(4);
  EXPECT_DOUBLE_EQ(last_activity()->share, 0.25);
  const auto begin = last_activity()->begin;
  {
    const Activity uncounted("uncounted");
    Activity inner("inner", 10);
    inner.done(5);
    EXPECT_EQ(last_activity()->name, "inner");
    EXPECT_DOUBLE_EQ(last_activity()->share, 0.5);
    EXPECT_EQ(last_activity()->begin, begin);
  }
  outer.next(2);
  EXPECT_DOUBLE_EQ(last_activity()->share, 0.75);
}

TEST(Activity, AsksWhetherToStop) {
  const NoQuestion at_the_end;
  Activity activity("waiting", 2);
  stop_loops_when([] { return StopCause::request; });
  EXPECT_THROW(activity.done(1), Stopped);
  EXPECT_THROW(activity.next(), Stopped);
  EXPECT_THROW(Activity("another"), Stopped);
  EXPECT_EQ(last_activity()->name, "waiting");
}

TEST(StopCheck, AsksAtTheFirstCallAndThenNowAndAgain) {
  const NoQuestion at_the_end;
  StopCheck check;
  check();
  stop_loops_when([] { return StopCause::request; });
  int n = 0;
  EXPECT_THROW(for (;; ++n) check(), Stopped);
  EXPECT_GT(n, 100);
  EXPECT_LT(n, 10000);
  EXPECT_THROW(StopCheck()(), Stopped);
}

}  // namespace
}  // namespace shellmatch
