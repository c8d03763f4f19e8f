#include "apps/studies/report/convergence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shellmatch {
namespace {

// Levels 3 and 4; level 4 has two substeps. Level 3 took two evaluations more than its last accepted step
// tells.
struct TwoLevels {
  History history;
  MatchSummary summary;

  TwoLevels() {
    history.rows = {
        {3, 1, 1.0, {0, 9.0, {}, 0, 0, 0, 1, 1, 0.1, ""}},  {3, 1, 1.0, {1, 8.0, {}, 0, 0, 0, 4, 2, 0.5, ""}},
        {4, 1, 0.5, {0, 7.0, {}, 0, 0, 0, 1, 1, 0.2, ""}},  {4, 1, 0.5, {1, 0.5, {}, 0, 0, 0, 3, 3, 1.0, ""}},
        {4, 2, 0.1, {0, 20.0, {}, 0, 0, 0, 1, 1, 0.1, ""}}, {4, 2, 0.1, {1, 11.0, {}, 0, 0, 0, 2, 2, 0.4, ""}},
        {4, 2, 0.1, {2, 10.0, {}, 0, 0, 0, 7, 5, 2.0, ""}}};
    LevelSummary coarse, fine;
    coarse.level = 3;
    coarse.value_evaluations = 6;
    coarse.gradient_evaluations = 2;
    fine.level = 4;
    fine.n_substeps = 2;
    summary.levels = {coarse, fine};
    summary.run.level_seconds = {0.75, 3.0};
  }
};

TEST(Convergence, CountsTheWholeCascade) {
  const TwoLevels run;
  const auto points = finest_convergence(run.history, run.summary, 4);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].value, 20.0);
  EXPECT_EQ(points[0].evaluations, 6 + 3 + 1);
  EXPECT_EQ(points[2].evaluations, 6 + 3 + 7);
  EXPECT_EQ(points[2].gradient_evaluations, 2 + 3 + 5);
  EXPECT_DOUBLE_EQ(points[2].seconds, 0.75 + 1.0 + 2.0);
}

TEST(Convergence, NothingWhereTheFinestLevelWasNotReached) {
  TwoLevels run;
  EXPECT_TRUE(finest_convergence(run.history, run.summary, 5).empty());
  run.history.rows.resize(4);  // stopped before the last substep, whose energy alone can be compared
  EXPECT_TRUE(finest_convergence(run.history, run.summary, 4).empty());
}

TEST(Convergence, TheFirstStepWithinTheGap) {
  const TwoLevels run;
  const auto points = finest_convergence(run.history, run.summary, 4);
  // The energy 0.5 of an earlier minimisation is lower, and means nothing.
  const auto tenth = cost_to_gap(points, 10.0, 0.1);
  ASSERT_TRUE(tenth);
  EXPECT_EQ(tenth->evaluations, 11);
  EXPECT_DOUBLE_EQ(tenth->seconds, 2.15);
  EXPECT_EQ(cost_to_gap(points, 10.0, 0.09)->evaluations, 16);
  EXPECT_EQ(cost_to_gap(points, 10.0, 1.0)->evaluations, 10);
  EXPECT_FALSE(cost_to_gap(points, 9.0, 0.1));
}

TEST(Convergence, GapsOfWhatCannotBeCompared) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DOUBLE_EQ(relative_gap(1.5, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(relative_gap(-1.0, -2.0), 0.5);
  EXPECT_TRUE(std::isnan(relative_gap(nan, 1)));
  EXPECT_TRUE(std::isnan(relative_gap(1, nan)));
  EXPECT_TRUE(std::isnan(relative_gap(1, 0)));
  EXPECT_FALSE(cost_to_gap({{0, nan, 1, 1, 1}}, 1, 1e9));
}

}  // namespace
}  // namespace shellmatch
