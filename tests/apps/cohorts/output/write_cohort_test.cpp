// What is said where a cohort is stopped after its matchings.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/stop.h"
#include "apps/cohorts/execution/atlas.h"
#include "apps/cohorts/output/write_cohort.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

TEST(WriteCohort, AStopSaysThatTheMatchingsAreKept) {
  const fs::path folder = fs::path(testing::TempDir()) / "shellmatch_write_cohort_stopped";
  OriginalShape<2> circle;
  circle.polygons.emplace_back();
  for (int k = 0; k < 12; ++k) {
    circle.vertices.push_back({std::cos(k * 0.5), std::sin(k * 0.5)});
    circle.polygons.back().push_back(static_cast<Index>(k));
  }
  FinishedCohort<2> finished;
  finished.atlas = make_atlas<2>(circle, {}, folder.string(), "atlas");
  Cohort cohort;
  cohort.subjects.resize(3);
  finished.stage.subjects.resize(3);
  finished.stage.rows = {0, 1, 2};
  finished.stage.points = {2, finished.atlas.points.replicate(1, 3)};
  std::vector<std::string> notes;
  std::string said;
  stop_loops_when([] { return StopCause::time_limit; });
  try {
    write_cohort<2>(cohort, std::move(finished), folder.string(), notes);
  } catch (const Stopped& stopped) {
    said = stopped.what();
    EXPECT_EQ(stopped.cause(), StopCause::time_limit);
  }
  stop_loops_when(nullptr);
  EXPECT_NE(said.find("have finished are kept in " + folder.string()), std::string::npos) << said;
  EXPECT_NE(said.find("the same command goes on"), std::string::npos) << said;
  fs::remove_all(folder);
}

}  // namespace
}  // namespace shellmatch
