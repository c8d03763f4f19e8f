// A run that is stopped in its alignment goes on where that was, and ends with the same bits.

#include "tests/matching/checkpoint/stopped_run.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::contents_of;
using testing::expect_same_bits;
using testing::experiment;
using testing::run;
using testing::stop_at;
using testing::TemporaryFolder;
using testing::Watcher;

// Whatever part of the alignment is the last to be finished.
TEST(Resume, AStopInTheAlignmentKeepsWhatItHasFound) {
  const TemporaryFolder tmp;
  ExperimentOptions o = experiment();
  o.align.mode = AlignMode::automatic;
  o.input.template_file = "generate:leaf";
  const int n_of_trials = run(o, tmp / "whole").n_of_trials;
  ASSERT_GT(n_of_trials, 2);
  const std::string out = tmp / "out", state = out + ".unfinished";
  int fewest_left = n_of_trials;
  for (const int moment : {1, n_of_trials / 2, n_of_trials}) {
    SCOPED_TRACE(moment);
    Watcher watcher;
    watcher.most_of_trials = moment;
    const std::string told = testing::message_of<Stopped>([&] { run_matching(o, out, {}, watcher); });
    EXPECT_NE(told.find("stopped in the alignment; what was found so far is kept in " + fs::canonical(state).string() +
                        ": the same command goes on from there"),
              std::string::npos)
        << told;
    EXPECT_FALSE(fs::exists(out));
    const Watcher resumed = run(o, out);
    EXPECT_NE(resumed.notes.find("going on with what the alignment has found"), std::string::npos) << resumed.notes;
    EXPECT_LE(resumed.n_of_trials, fewest_left);
    fewest_left = resumed.n_of_trials;
    EXPECT_EQ(resumed.levels.size(), 3u);
    expect_same_bits(tmp / "whole", out);
    fs::remove_all(out);
    EXPECT_EQ(std::distance(fs::directory_iterator(tmp / ""), fs::directory_iterator()), 1) << "something was left";
  }
  EXPECT_LT(fewest_left, n_of_trials);

  // After a level nothing of it is searched or tried again.
  stop_at(4, o, out);
  Watcher anew;
  anew.most_of_trials = 1;
  run_matching(o, out, {}, anew);
  EXPECT_EQ(anew.levels, (std::vector<int>{4, 5}));
  expect_same_bits(tmp / "whole", out);
}

TEST(Resume, AStopBeforeALevelIsKeptKeepsTheAlignment) {
  const TemporaryFolder tmp;
  ExperimentOptions o = experiment();
  o.align.mode = AlignMode::automatic;
  o.input.template_file = "generate:leaf";
  run(o, tmp / "whole");
  // Longer than the alignment takes, and less than ten times as long.
  for (const auto& [phase, seconds] : read_summary(tmp / "whole/summary.json").run.phase_seconds)
    if (phase == "alignment") o.resume.min_seconds = 3 * seconds;
  const std::string told = stop_at(3, o, tmp / "out");
  EXPECT_NE(told.find("stopped in level 3 of 5; the alignment is kept in"), std::string::npos) << told;
  const Watcher resumed = run(o, tmp / "out");
  EXPECT_NE(resumed.notes.find("going on with what the alignment has found"), std::string::npos) << resumed.notes;
  EXPECT_EQ(resumed.n_of_trials, 0);
  fs::remove_all(tmp / "whole/config.yaml");
  fs::remove_all(tmp / "out/config.yaml");  // which names min_seconds
  expect_same_bits(tmp / "whole", tmp / "out");
}

TEST(Resume, ALevelIsWorthMoreThanAnAlignment) {
  const TemporaryFolder tmp;
  ExperimentOptions o = experiment();
  stop_at(5, o, tmp / "out");
  const auto before = contents_of(tmp / "out.unfinished/deformation.vtu");
  o.align.mode = AlignMode::automatic;
  Watcher watcher;
  watcher.most_of_trials = 1;
  const std::string told = testing::message_of<Stopped>([&] { run_matching(o, tmp / "out", {}, watcher); });
  EXPECT_NE(told.find("stopped in the alignment; nothing was written"), std::string::npos) << told;
  EXPECT_EQ(contents_of(tmp / "out.unfinished/deformation.vtu"), before);
}

}  // namespace
}  // namespace shellmatch
