// A run that is stopped goes on at its last finished level and ends with the same bits; what does not belong to it is
// noticed and never mixed in.

#include "base/error.h"
#include "base/stop.h"
#include "matching/output/checksum.h"
#include "matching/map_file/deformation_file.h"
#include "matching/checkpoint/checkpoints.h"
#include "matching/run_matching.h"
#include "matching/output/summary.h"
#include "matching/output/written_files.h"
#include "tests/matching/checkpoint/stopped_run.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::contents_of;
using testing::expect_same_bits;
using testing::experiment;
using testing::lasting;
using testing::put;
using testing::run;
using testing::stop_at;
using testing::TemporaryFolder;
using testing::Watcher;

void check_every_stop(const ExperimentOptions& o) {
  const TemporaryFolder tmp;
  run(o, tmp / "whole");
  for (const int level : {4, 5, 100}) {
    SCOPED_TRACE(level);
    const int kept = std::min(level - 1, 5);
    const std::string out = tmp / "out", state = out + ".unfinished";
    const std::string told = stop_at(level, o, out);
    EXPECT_NE(told.find(level == 100 ? "while the result was written" : "in level " + std::to_string(level)),
              std::string::npos)
        << told;
    EXPECT_NE(told.find("level " + std::to_string(kept) + " is kept in " + fs::canonical(state).string()),
              std::string::npos)
        << told;
    EXPECT_FALSE(fs::exists(out));
    EXPECT_EQ(read_summary(state + "/summary.json").levels.back().level, kept);

    const Watcher resumed = run(o, out);
    EXPECT_NE(resumed.notes.find("going on after level " + std::to_string(kept)), std::string::npos) << resumed.notes;
    EXPECT_EQ(std::count(resumed.notes.begin(), resumed.notes.end(), '\n'), 1);
    EXPECT_EQ(resumed.levels.size(), static_cast<std::size_t>(5 - kept));
    expect_same_bits(tmp / "whole", out);
    EXPECT_EQ(read_summary(out + "/summary.json").run.resumed_after, std::vector<int>{kept});
    fs::remove_all(out);
    EXPECT_EQ(std::distance(fs::directory_iterator(tmp / ""), fs::directory_iterator()), 1) << "something was left";
  }
}

TEST(Resume, AfterAStopAtAnyLevelTheResultIsTheSameToTheBit) {
  check_every_stop(experiment(Pictures::all));
  ExperimentOptions o = experiment();
  o.coefficients.interpolation = FieldInterpolation::multilinear;
  check_every_stop(o);
  o = experiment();
  o.input.template_file = "generate:leaf";  // the verdict has reasons with places
  check_every_stop(o);
}

TEST(Resume, StoppedAgainAndAgainTimesAddUp) {
  const TemporaryFolder tmp;
  ExperimentOptions o = experiment();
  o.check_gradient.every = 3;
  run(o, tmp / "whole");
  double seconds = 0;
  for (const int level : {4, 5}) {
    struct Slow final : Watcher {
      bool iterated(const LevelStart& start, const IterationRecord& record) override {
        if (start.level == 3 && record.iteration == 0) std::this_thread::sleep_for(std::chrono::milliseconds(400));
        return true;
      }
    } slow;
    stop_at(level, o, tmp / "out", std::move(slow));
    const RunFigures figures = read_summary(tmp / "out.unfinished/summary.json").run;
    EXPECT_GE(figures.seconds, seconds + figures.level_seconds.back());
    seconds = figures.seconds;
    o.threads = level % 2 + 1;  // changes no result
  }
  run(o, tmp / "out");
  const MatchSummary s = read_summary(tmp / "out/summary.json");
  EXPECT_GE(s.run.seconds, seconds + s.run.level_seconds.back());
  EXPECT_EQ(s.run.level_seconds.size(), 3u);
  EXPECT_EQ(s.run.resumed_after, (std::vector<int>{3, 4}));
  auto whole = lasting(tmp / "whole"), parts = lasting(tmp / "out");
  EXPECT_NE(whole["summary.json"].find("gradient_checks"), std::string::npos);
  EXPECT_NE(whole["config.yaml"], parts["config.yaml"]);
  parts["config.yaml"] = whole["config.yaml"];
  EXPECT_EQ(whole, parts);
}

// The kept map is a result in its own right.
TEST(Resume, TheFolderSaysWhatItIsAndHoldsTheMap) {
  const TemporaryFolder tmp;
  ExperimentOptions fine = experiment();
  fine.coefficients.levels_ahead = 0;  // a level is then the same whatever the finest one is
  fine.coverage.levels = 1;            // none on level 4
  stop_at(5, fine, tmp / "out");
  EXPECT_NE(contents_of(tmp / "out.unfinished/README.txt").find("The same command"), std::string::npos);
  EXPECT_TRUE(read_summary(tmp / "out.unfinished/summary.json").interrupted);
  ExperimentOptions coarse = fine;
  coarse.cascade.max_level = 4;
  coarse.coverage.levels = 0;
  coarse.cascade.sigma_cells = coarse.cascade.coarse_sigma_cells;
  coarse.solver.stop.relative_decrease = coarse.cascade.intermediate_decrease;
  run(coarse, tmp / "coarse");
  EXPECT_EQ(read_deformation<2>(tmp / "out.unfinished").phi, read_deformation<2>(tmp / "coarse").phi);
}

TEST(Resume, AnotherConfigurationBeginsAnew) {
  const TemporaryFolder tmp;
  ExperimentOptions o = experiment();
  stop_at(5, o, tmp / "out");
  o.cascade.nu = 0.001;
  o.resume.min_seconds = 1e-9;  // no matter
  run(o, tmp / "whole");
  const Watcher anew = run(o, tmp / "out");
  EXPECT_NE(anew.notes.find("configuration has changed (cascade.nu: 0.0002, now 0.001)"), std::string::npos)
      << anew.notes;
  EXPECT_EQ(anew.levels.front(), 3);
  expect_same_bits(tmp / "whole", tmp / "out");
  EXPECT_FALSE(fs::exists(tmp / "out.unfinished"));
}

TEST(Resume, WhatIsInAFileCountsAndNotItsName) {
  const TemporaryFolder tmp;
  const auto polygon = [](double height) {
    std::string text;
    for (int i = 0; i < 40; ++i)
      text += fmt::format("{},{}\n", std::cos(i * std::acos(0.0) / 10), height * std::sin(i * std::acos(0.0) / 10));
    return text;
  };
  put(tmp / "a.csv", polygon(0.8));
  put(tmp / "b.csv", polygon(0.8));
  ExperimentOptions o = experiment();
  o.input.template_file = tmp / "a.csv";
  stop_at(5, o, tmp / "out");
  o.input.template_file = tmp / "b.csv";
  EXPECT_EQ(run(o, tmp / "out").levels, std::vector<int>{5});

  stop_at(5, o, tmp / "out2");
  put(tmp / "b.csv", polygon(0.8001));
  const Watcher anew = run(o, tmp / "out2");
  EXPECT_NE(anew.notes.find("the template is another one"), std::string::npos) << anew.notes;
  EXPECT_EQ(anew.levels.front(), 3);
  run(o, tmp / "whole");
  expect_same_bits(tmp / "whole", tmp / "out2");
}

// A larger template changes where both shapes lie in the unit domain.
TEST(Resume, TheShapeThatHasChangedIsNamed) {
  const TemporaryFolder tmp;
  const auto ellipse = [](double width) {
    std::string text;
    for (int i = 0; i < 60; ++i)
      text += fmt::format("{},{}\n", width * std::cos(i * std::acos(0.0) / 15), std::sin(i * std::acos(0.0) / 15));
    return text;
  };
  put(tmp / "reference.csv", ellipse(1));
  put(tmp / "template.csv", ellipse(1.2));
  ExperimentOptions o = experiment();
  o.input.reference = tmp / "reference.csv";
  o.input.template_file = tmp / "template.csv";
  stop_at(4, o, tmp / "out");
  put(tmp / "template.csv", ellipse(1.3));
  const std::string notes = run(o, tmp / "out").notes;
  EXPECT_NE(notes.find("the template is another one"), std::string::npos) << notes;
  stop_at(4, o, tmp / "out2");
  put(tmp / "reference.csv", ellipse(1.1));
  const std::string others = run(o, tmp / "out2").notes;
  EXPECT_NE(others.find("the reference is another one"), std::string::npos) << others;
}

TEST(Resume, DamagedStatesBeginAnewWithOneWarning) {
  const TemporaryFolder tmp;
  const ExperimentOptions o = experiment();
  run(o, tmp / "whole");
  for (const std::string file :
       {"deformation.vtu", "history.csv", "summary.json", "config.yaml", "levels.bin", "alignment.cbor", "state.json"})
    for (const bool cut : {true, false}) {
      SCOPED_TRACE(file + (cut ? " cut off" : " changed"));
      stop_at(4, o, tmp / "out");
      const std::string path = tmp / ("out.unfinished/" + file);
      std::string contents = contents_of(path);
      if (cut) contents.resize(contents.size() / 2);
      else contents[contents.size() / 2] ^= 1;
      put(path, contents);
      const Watcher anew = run(o, tmp / "out");
      EXPECT_NE(anew.notes.find("begins anew"), std::string::npos) << anew.notes;
      EXPECT_EQ(std::count(anew.notes.begin(), anew.notes.end(), '\n'), 1);
      EXPECT_EQ(anew.levels.front(), 3);
      expect_same_bits(tmp / "whole", tmp / "out");
      EXPECT_FALSE(fs::exists(tmp / "out.unfinished"));
      fs::remove_all(tmp / "out");
    }
}

// Whole to the last byte, and yet nothing that a run could go on from.
TEST(Resume, AStateThatCannotBeReadBeginsAnew) {
  const TemporaryFolder tmp;
  const ExperimentOptions o = experiment();
  stop_at(4, o, tmp / "out");
  put(tmp / "out.unfinished/history.csv", "rubbish\n");
  write_file_list(tmp / "out.unfinished");
  const Watcher anew = run(o, tmp / "out");
  EXPECT_NE(anew.notes.find("it cannot be read"), std::string::npos) << anew.notes;
  EXPECT_EQ(anew.levels.front(), 3);
  EXPECT_FALSE(fs::exists(tmp / "out.unfinished"));
}

TEST(Resume, RestartBeginsAnewAndForceDoesNot) {
  const TemporaryFolder tmp;
  const ExperimentOptions o = experiment();
  stop_at(5, o, tmp / "out");
  const Watcher anew = run(o, tmp / "out", {.restart = true});
  EXPECT_EQ(anew.levels.front(), 3);
  EXPECT_EQ(anew.notes, "");
  Watcher watcher;
  watcher.action = [](int level) {
    if (level == 5) throw Stopped("now");
  };
  EXPECT_THROW(run_matching(o, tmp / "out", {.force = true}, watcher), Stopped);
  EXPECT_TRUE(fs::exists(tmp / "out/summary.json")) << "the result of the run before is gone";
  EXPECT_EQ(run(o, tmp / "out", {.force = true}).levels, std::vector<int>{5});
}

TEST(Resume, ShortRunsAndThoseThatShallNotLeaveNothing) {
  const TemporaryFolder tmp;
  ExperimentOptions brief = experiment(), never = experiment();
  brief.resume.min_seconds = 1000;
  never.resume.enabled = false;
  for (const ExperimentOptions& o : {brief, never}) {
    const std::string told = stop_at(5, o, tmp / "out");
    EXPECT_NE(told.find("nothing was written"), std::string::npos) << told;
    EXPECT_EQ(tmp.entries(), std::vector<std::string>{});
  }
}

// While it lives, no file grows beyond this size: a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t size) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{size, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(Resume, AFullDiskCostsNoLevelThatIsKept) {
  const TemporaryFolder tmp;
  const ExperimentOptions o = experiment();
  run(o, tmp / "whole");
  struct Case {
    int full_at;  // from here to the beginning of the next level; 100: while the result is written
    std::string told;
    int last_kept;
  };
  for (const auto& [full_at, told, last_kept] :
       {Case{4, "level 4 is not kept", 3}, Case{100, "cannot be written", 5}}) {
    SCOPED_TRACE(full_at);
    Watcher watcher;
    std::optional<FullDisk> full;
    int kept = 0;
    watcher.action = [&](int begins) {
      if (full) kept = read_summary(tmp / "out.unfinished/summary.json").levels.back().level;
      full.reset();
      if (begins == full_at) full.emplace(1000);
    };
    watcher.notes =
        testing::message_of<EnvironmentError>([&] { run_matching(o, tmp / "out", {}, watcher); }) + watcher.notes;
    full.reset();
    EXPECT_NE(watcher.notes.find(told), std::string::npos) << watcher.notes;
    if (full_at == 100) {
      EXPECT_FALSE(fs::exists(tmp / "out"));
      kept = read_summary(tmp / "out.unfinished/summary.json").levels.back().level;
      EXPECT_EQ(run(o, tmp / "out").levels, std::vector<int>{});
    }
    EXPECT_EQ(kept, last_kept);
    expect_same_bits(tmp / "whole", tmp / "out");
    EXPECT_FALSE(fs::exists(tmp / "out.unfinished"));
    fs::remove_all(tmp / "out");
  }
}

TEST(Resume, WhatSomebodyElseHasWrittenThereStays) {
  const TemporaryFolder tmp;
  fs::create_directories(tmp / "out.unfinished");
  put(tmp / "out.unfinished/summary.json", "years of work");
  put(tmp / "file.unfinished", "years of work");
  for (const std::string name : {"out", "file"}) {
    const Watcher watcher = run(experiment(), tmp / name);
    EXPECT_NE(watcher.notes.find("levels are not kept"), std::string::npos) << watcher.notes;
    EXPECT_EQ(std::count(watcher.notes.begin(), watcher.notes.end(), '\n'), 1);
    EXPECT_TRUE(fs::exists(tmp / (name + "/summary.json")));
  }
  EXPECT_EQ(contents_of(tmp / "out.unfinished/summary.json"), "years of work");
  EXPECT_EQ(contents_of(tmp / "file.unfinished"), "years of work");
}

}  // namespace
}  // namespace shellmatch
