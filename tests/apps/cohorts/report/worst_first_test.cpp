// The subjects that need a look come first.

#include "apps/cohorts/report/worst_first.h"

#include "tests/apps/cohorts/report/cohort_samples.h"

#include <gtest/gtest.h>

#include <limits>

namespace shellmatch {
namespace {

SubjectResult subject(const std::string& status, const std::string& outcome, double there, double back) {
  SubjectResult s;
  s.status = status;
  s.outcome = outcome;
  s.distance = TwoSidedDistance{{0, 0, there}, {0, 0, back}};
  return s;
}

TEST(WorstFirst, FailuresThenVerdictsThenTheGreatestDistanceEitherWay) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SubjectResult unmeasured = subject("finished", "look-here", 0, 0);
  unmeasured.distance.reset();
  const std::vector<SubjectResult> subjects = {
      subject("finished", "matched", 0.01, 0.02),      // 0
      subject("finished", "matched", 0.03, 0.01),      // 1
      subject("finished", "not-matched", 0.02, 0.02),  // 2
      test::unfinished_subject("late", "timed_out"),   // 3
      subject("finished", "look-here", 0.5, 0.01),     // 4
      unmeasured,                                      // 5
      subject("finished", "matched", 0.01, nan),       // 6
      test::unfinished_subject("later", "not_run"),    // 7
      subject("finished", "matched", 0.02, 0.04),      // 8
      subject("finished", "matched", 0.04, 0.01),      // 9: as far as 8, and after it in the table
  };
  EXPECT_EQ(worst_first(subjects), (std::vector<std::size_t>{3, 7, 2, 5, 4, 6, 8, 9, 1, 0}));
}

TEST(WorstFirst, TakesNone) { EXPECT_TRUE(worst_first({}).empty()); }

}  // namespace
}  // namespace shellmatch
