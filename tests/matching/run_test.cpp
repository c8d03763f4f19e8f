// A whole run: every file of the output folder is there, the summary agrees with the files, and what is wrong leaves
// nothing behind.

#include "base/error.h"
#include "matching/map_file/deformation_file.h"
#include "matching/derivative_check/gradient_report.h"
#include "matching/run_gradient_check.h"
#include "matching/run_matching.h"
#include "matching/result/correspondence.h"
#include "matching/output/summary.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

struct RunTest : ::testing::Test {
  fs::path folder = fs::temp_directory_path() / ("shellmatch_run_test_" + std::to_string(::getpid()));
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  static ExperimentOptions options(const std::string& reference, const std::string& target, int max_level) {
    ExperimentOptions o = profile_defaults(Profile::standard);
    o.input.reference = reference;
    o.input.template_file = target;
    o.cascade.max_level = max_level;
    return o;
  }
};

TEST_F(RunTest, WritesEveryFileAndMatches) {
  Observer quiet;
  const std::string out = folder / "out";
  ExperimentOptions o = options("generate:circle", "generate:ellipse/long", 7);
  o.pictures = Pictures::all;
  run_matching(o, out, {}, quiet);
  for (const char* name :
       {"deformed.csv", "template.csv", "deformation.vtu", "history.csv", "summary.json", "config.yaml",
        "pictures/result.png", "report.html", "pictures/energy.png", "pictures/level_07.png"})
    EXPECT_TRUE(fs::exists(fs::path(out) / name)) << name;
  const MatchSummary s = read_summary(fs::path(out) / "summary.json");
  EXPECT_EQ(s.levels.size(), 5u);
  EXPECT_LT(s.distance->deformed_to_template.mean, 1e-3);
  EXPECT_LT(s.distance->template_to_deformed.mean, 1e-3);
  EXPECT_GT(s.distance_before->deformed_to_template.mean, 1e-2);
  EXPECT_EQ(s.levels.back().folds.n_uncertified_cells, 0);
  EXPECT_EQ(deformation_dimension(out), 2);
  EXPECT_EQ(static_cast<Index>(read_deformation<2>(out).grid.n_nodes()), s.levels.back().n_nodes);
}

TEST_F(RunTest, TheSummaryIsTheSameForAnyNumberOfThreads) {
  Observer quiet;
  std::string first;
  for (const int threads : {1, 2}) {
    ExperimentOptions o = options("generate:circle", "generate:ellipse/long", 6);
    o.threads = threads;
    const fs::path out = folder / std::to_string(threads);
    run_matching(o, out, {}, quiet);
    MatchSummary s = read_summary(out / "summary.json");
    s.run = {};
    if (threads == 1) first = summary_json(s);
    else EXPECT_EQ(summary_json(s), first);
  }
}

TEST_F(RunTest, DerivativesAreCheckedOnTheWayAndChangeNothing) {
  struct Listener final : Observer {
    int n = 0;
    void gradient_checked(const LevelStart&, const GradientReport& report) override {
      ++n;
      EXPECT_TRUE(report.passed()) << gradient_report_text(report);
    }
  };
  std::string unchecked;
  for (const int every : {0, 3}) {
    ExperimentOptions o = options("generate:circle", "generate:ellipse/long", 4);
    o.check_gradient.every = every;
    const fs::path out = folder / ("every" + std::to_string(every));
    Listener listener;
    run_matching(o, out, {}, listener);
    MatchSummary s = read_summary(out / "summary.json");
    EXPECT_EQ(s.gradient_checks.has_value(), every > 0);
    if (every > 0) {
      ASSERT_EQ(static_cast<int>(s.gradient_checks->size()), listener.n);
      // Four minimisations, each checked at its start, and some at their third iteration.
      EXPECT_GT(listener.n, 4);
      for (const GradientCheckSummary& c : *s.gradient_checks) {
        EXPECT_TRUE(c.passed);
        EXPECT_EQ(c.iteration % 3, 0);
        EXPECT_NEAR(c.worst_order, 2, 0.1);
        EXPECT_NE(c.worst_order, 2);
      }
    }
    s.gradient_checks.reset();
    s.run = {};
    if (every == 0) unchecked = summary_json(s);
    else EXPECT_EQ(summary_json(s), unchecked);
  }
}

TEST_F(RunTest, IdenticalShapesStayWhereTheyAre) {
  Observer quiet;
  run_matching(options("generate:circle", "generate:circle", 6), folder / "same", {}, quiet);
  const MatchSummary s = read_summary(folder / "same" / "summary.json");
  EXPECT_LT(s.distance->deformed_to_template.max, 1e-4);
  EXPECT_GT(s.levels.back().folds.lower_bound, 0.9);
}

TEST_F(RunTest, DifferentDimensionsAreRefusedAndNothingIsLeft) {
  Observer quiet;
  EXPECT_THROW(run_matching(options("generate:circle", "generate:sphere", 4), folder / "x", {}, quiet), InputError);
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(RunTest, OptionsThatAProgramHasSetAreCheckedBeforeAnythingIsRead) {
  struct Listener final : Observer {
    void stage(const std::string& name) override { ADD_FAILURE() << name; }
  } listener;
  ExperimentOptions no_levels = options("generate:circle", "generate:ellipse/long", 2);
  expect_input_error([&] { run_matching(no_levels, folder / "x", {}, listener); },
                     {"cascade.max_level: 2 is below cascade.min_level = 3"});
  expect_input_error([&] { run_gradient_check(no_levels, {}, listener); }, {"cascade.max_level"});
  ExperimentOptions no_material = options("generate:circle", "generate:ellipse/long", 4);
  no_material.energy.mu = std::nan("");
  expect_input_error([&] { run_matching(no_material, folder / "x", {}, listener); },
                     {"energy.mu: nan is out of range"});
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(RunTest, AnInterruptedRunIsWrittenWholeAndSaysSo) {
  struct Stop final : Observer {
    bool iterated(const LevelStart& start, const IterationRecord&) override { return start.level < 5; }
  } stop;
  run_matching(options("generate:circle", "generate:ellipse/long", 7), folder / "part", {}, stop);
  const MatchSummary s = read_summary(folder / "part" / "summary.json");
  EXPECT_TRUE(s.interrupted);
  EXPECT_EQ(s.levels.back().level, 5);
  EXPECT_NO_THROW(read_deformation<2>(folder / "part"));
}

TEST_F(RunTest, WithoutAPageTheEndAloneIsMeasured) {
  struct Stop final : Observer {
    bool iterated(const LevelStart& start, const IterationRecord&) override { return start.level < 5; }
  } stop;
  Observer quiet;
  ExperimentOptions o = options("generate:circle", "generate:ellipse/long", 6);
  const auto measured = [&](Observer& observer) {
    run_matching(o, folder / "out", {.force = true}, observer);
    const MatchSummary s = read_summary(folder / "out" / "summary.json");
    EXPECT_TRUE(s.distance);
    return std::ranges::count_if(s.levels, [](const LevelSummary& level) { return level.distance.has_value(); });
  };
  EXPECT_EQ(measured(quiet), 4);
  o.report = false;
  EXPECT_EQ(measured(quiet), 1);
  EXPECT_EQ(measured(stop), 0);
}

TEST_F(RunTest, CorrespondenceFilesAreCheckedLineByLine) {
  const fs::path file = folder / "truth.txt";
  const auto message = [&](const std::string& text) -> std::string {
    std::ofstream(file) << text;
    try {
      read_correspondence<2>(file, 10);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message("# truth\n0 0.5 0.5\n\n9 1 2\n"), "");
  EXPECT_NE(message("0 0.5 0.5\n10 0 0\n").find(":2: there is no vertex 10"), std::string::npos);
  EXPECT_NE(message("0 0.5\n").find(":1: expected"), std::string::npos);
  EXPECT_NE(message("0 0.5 nan\n").find(":1: expected"), std::string::npos);
  EXPECT_NE(message("# nothing\n").find("holds no correspondence"), std::string::npos);
}

}  // namespace
}  // namespace shellmatch
