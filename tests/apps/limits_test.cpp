// --max-seconds and --max-memory, kept by the program.

#include "apps/process/limits.h"
#include "matching/output/summary.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"
#include "tests/support/slowdown.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::contents_of;
using testing::put;
using testing::TemporaryFolder;
using Clock = std::chrono::steady_clock;

Words match(const std::string& out, const std::string& levels, const Words& more = {}) {
  Words words{"match",
              "generate:sphere",
              "generate:ellipsoid/long",
              "-o",
              out,
              "--levels",
              levels,
              "--align",
              "none",
              "--set",
              "resume.min_seconds=0",
              "--set",
              "pictures=none"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Limits, TimeEndsARunInOrderAndTheSameCommandGoesOn) {
  const TemporaryFolder tmp;
  const auto begin = Clock::now();
  const ProgramResult stopped = run_program(match(tmp / "o", "2:9", {"--max-seconds", "3"}));
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(3 + 3 * test::slowdown));
  EXPECT_EQ(stopped.exit_code, 4) << stopped.err;
  const std::string told = last_line(stopped.err);
  EXPECT_TRUE(has(told, "--max-seconds 3 is over: stopped in level")) << told;
  EXPECT_TRUE(has(told, "o.unfinished: the same command goes on from there")) << told;
  ASSERT_TRUE(fs::exists(tmp / "o.unfinished/state.json"));
  EXPECT_FALSE(fs::exists(tmp / "o"));
  const ProgramResult resumed = run_program(match(tmp / "o", "2:9", {"--max-seconds", test::slowdown > 1 ? "8" : "1"}));
  EXPECT_EQ(resumed.exit_code, 4);
  EXPECT_TRUE(has(resumed.err, "going on after level")) << resumed.err;
}

// Of every level, not of the finest alone, which needs no new nodes of the shapes' own grids.
TEST(Limits, EstimatesAreWithinThirtyPercentOfThePeak) {
  struct Case {
    const char *reference, *template_shape, *levels;
  };
  for (const Case& c :
       {Case{"generate:sphere", "generate:ellipsoid/long", "3:6"}, Case{"generate:hand", "generate:hand/bent", "3:5"},
        Case{"generate:circle", "generate:ellipse/long", "4:9"}}) {
    SCOPED_TRACE(c.reference);
    const TemporaryFolder tmp;
    const ProgramResult run =
        run_program({"match", c.reference, c.template_shape, "-o", tmp / "o", "--levels", c.levels, "--align", "none",
                     "-q", "--set", "pictures=none", "--set", "solver.stop.max_iterations=2"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const MatchSummary s = read_summary(tmp / "o/summary.json");
    const std::vector<double> estimates = s.run.level_memory_estimates.value(),
                              peaks = s.run.level_memory_peaks.value();
    ASSERT_EQ(estimates.size(), s.levels.size());
    ASSERT_EQ(peaks.size(), s.levels.size());
    for (std::size_t i = 0; i < peaks.size(); ++i) {
      EXPECT_GT(estimates[i], 0.77 * peaks[i]) << i;
      EXPECT_LT(estimates[i], 1.3 * peaks[i]) << i;
    }
  }
}

TEST(Limits, EveryCommandKeepsThem) {
  const TemporaryFolder tmp;
  const auto expect_in_time = [&](const Words& words) {
    SCOPED_TRACE(words[0]);
    const auto begin = Clock::now();
    const ProgramResult result = run_program(words);
    EXPECT_LT(Clock::now() - begin, std::chrono::seconds(5));
    EXPECT_EQ(result.exit_code, 4) << result.err;
    EXPECT_TRUE(has(result.err, "--max-seconds")) << result.err;
  };
  expect_in_time({"curvature", "generate:sphere", "-o", tmp / "c", "--levels", "3:8", "--max-seconds", "1"});
  expect_in_time({"generate", "hand", "-o", tmp / "h.ply", "--edge-length", "0.003", "--max-seconds", "0.05"});
  expect_in_time({"self-test", "--max-seconds", "0.5"});
  put(tmp / "e.yaml",
      "input: {reference: 'generate:sphere', template: 'generate:ellipsoid'}\ncascade: {max_level: 7}\n");
  expect_in_time({"check-gradient", tmp / "e.yaml", "--level", "7", "--max-seconds", "1"});
  EXPECT_EQ(tmp.entries(), Words{"e.yaml"});
}

TEST(Limits, AStudyKeepsItsResults) {
  const TemporaryFolder tmp;
  put(tmp / "s.yaml",
      "version: 1\nproblems: {leaf: {set: {input: {reference: 'generate:sphere', template: 'generate:ellipsoid/long'}, "
      "cascade: {min_level: 3, max_level: 6}}}}\nsolvers: [newton]\n");
  const auto begin = Clock::now();
  const ProgramResult stopped = run_program({"study", tmp / "s.yaml", "-o", tmp / "o", "-q", "--max-seconds", "1"});
  EXPECT_LT(Clock::now() - begin, std::chrono::seconds(4));
  EXPECT_EQ(stopped.exit_code, 4) << stopped.err;
  EXPECT_TRUE(has(stopped.err, "--max-seconds 1 is over: stopped; the same command goes on where it was"))
      << stopped.err;
  // The runs share the memory; one that needs more is ended, and the others and the tables are complete. Again without
  // a run.
  for (int i = 0; i < 2; ++i) {
    const ProgramResult small = run_program({"study", tmp / "s.yaml", "-o", tmp / "o", "--max-memory", "60MB"});
    EXPECT_EQ(small.exit_code, 4) << small.err;
    EXPECT_TRUE(has(small.err, "--max-memory 60MB does not suffice: 1 of 1 runs ended at 60 MB")) << small.err;
    EXPECT_TRUE(has(contents_of(tmp / "o/table.csv"), "out_of_memory"));
  }
}

TEST(Limits, TextsThatAreNoneAreRefused) {
  for (const Words& words : {Words{"--max-memory", "4"}, Words{"--max-memory", "many"}, Words{"--max-memory", "-1GB"},
                             Words{"--max-memory", "1e30GB"}, Words{"--max-seconds", "0"}, Words{"--max-seconds", "5s"},
                             Words{"--max-seconds", "nan"}}) {
    const ProgramResult result = run_program({"config", words[0] + "=" + words[1]});
    EXPECT_EQ(result.exit_code, 2) << words[1];
    EXPECT_TRUE(has(result.err, words[0] + " " + words[1] + ": expected a number")) << result.err;
  }
  EXPECT_EQ(run_program({"config", "--max-seconds", "600"}).exit_code, 0);
  // A sanitizer reserves terabytes.
  if (test::slowdown == 1) {
    EXPECT_EQ(run_program({"config", "--max-memory", "1GB"}).exit_code, 0);
  }
}

}  // namespace
}  // namespace shellmatch
