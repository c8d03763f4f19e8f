// Runs that are stopped by signals, as a user and a scheduler meet them.

#include "matching/output/history_file.h"
#include "matching/output/summary.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::contents_of;
using testing::TemporaryFolder;

// Pictures, which take a second in all, leave the time to send a signal.
Words match_circle(const std::string& out, const Words& more = {}) {
  Words words{"match", "generate:circle", "generate:ellipse/long", "-o",    out,           "--levels", "3:6", "--align",
              "none",  "--set",           "resume.min_seconds=0",  "--set", "pictures=all"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void expect_same_results(const fs::path& a, const fs::path& b) {
  for (const char* file : {"deformed.csv", "deformation.vtu", "config.yaml", "pictures/level_04.png",
                           "pictures/level_06.png", "pictures/result.png", "pictures/energy.png"})
    EXPECT_EQ(contents_of(a / file), contents_of(b / file)) << file;
  std::vector<std::string> summaries;
  for (const fs::path& folder : {a, b}) {
    MatchSummary s = read_summary(folder / "summary.json");
    s.run = {};
    summaries.push_back(summary_json(s));
  }
  EXPECT_EQ(summaries[0], summaries[1]);
}

TEST(StoppedRun, SignalsAreToldInOneLineAndTheSameCommandGoesOn) {
  const TemporaryFolder tmp;
  ASSERT_EQ(run_program(match_circle(tmp / "whole")).exit_code, 0);
  for (const auto& [signal, exit_code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
    Program program(match_circle(tmp / "out"));
    ASSERT_TRUE(program.wait_for_stderr("level 5/6, step 1"));
    program.send_signal(signal);
    const ProgramResult stopped = program.wait();
    EXPECT_EQ(stopped.exit_code, exit_code);
    const std::size_t at = stopped.err.find("shellmatch: stopped in level ");
    ASSERT_NE(at, std::string::npos) << stopped.err;
    EXPECT_EQ(stopped.err.find('\n', at), stopped.err.size() - 1) << "more than one line: " << stopped.err.substr(at);
    EXPECT_NE(stopped.err.find("out.unfinished: the same command goes on from there", at), std::string::npos)
        << stopped.err;
    EXPECT_EQ(stopped.out, "");

    const ProgramResult resumed = run_program(match_circle(tmp / "out"));
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_EQ(resumed.err.rfind("going on after level ", 0), 0u) << resumed.err;
    EXPECT_EQ(resumed.err.find("level 4/6"), std::string::npos) << resumed.err;
    expect_same_results(tmp / "whole", tmp / "out");
    fs::remove_all(tmp / "out");
    EXPECT_EQ(std::distance(fs::directory_iterator(tmp / ""), fs::directory_iterator()), 1) << "something was left";
  }
}

TEST(StoppedRun, KilledAtAnyMomentItGoesOnAndCleansUp) {
  const TemporaryFolder tmp;
  ASSERT_EQ(run_program(match_circle(tmp / "whole")).exit_code, 0);
  for (const char* moment : {"level 3/6", "level 4/6, step 2", "level 5/6, step 3"}) {
    auto words = match_circle(tmp / "out");
    words.emplace_back("-v");  // a line for each step
    Program program(words);
    ASSERT_TRUE(program.wait_for_stderr(moment));
    program.send_signal(SIGKILL);
    EXPECT_EQ(program.wait().exit_code, 128 + SIGKILL);
  }
  EXPECT_TRUE(fs::exists(tmp / ".out.lock"));
  const ProgramResult resumed = run_program(match_circle(tmp / "out"));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(resumed.err.rfind("going on after level ", 0), 0u) << resumed.err;
  expect_same_results(tmp / "whole", tmp / "out");
  fs::remove_all(tmp / "out");
  EXPECT_EQ(std::distance(fs::directory_iterator(tmp / ""), fs::directory_iterator()), 1) << "something was left";
}

TEST(StoppedRun, TwoRunsOfOneNameDoNotMeet) {
  const TemporaryFolder tmp;
  Program first(match_circle(tmp / "out"));
  ASSERT_TRUE(first.wait_for_stderr("level 4/6"));
  first.send_signal(SIGSTOP);  // or it might be done before the second one looks
  const ProgramResult second = run_program(match_circle(tmp / "out"));
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_NE(second.err.find("another run is writing there"), std::string::npos) << second.err;
  first.send_signal(SIGCONT);
  EXPECT_EQ(first.wait().exit_code, 0);
  EXPECT_TRUE(fs::exists(tmp / "out/summary.json"));
}

// In the middle of a loop over the nodes of a large grid, seconds away from the next iteration.
TEST(StoppedRun, LongWorkIsLeftWithinASecond) {
  const TemporaryFolder tmp;
  Program program({"match", "generate:sphere", "generate:ellipsoid/long", "-o", tmp / "out", "--levels", "6:6",
                   "--align", "none", "-v"});
  ASSERT_TRUE(program.wait_for_stderr("matching ("));
  usleep(300000);
  const auto begin = std::chrono::steady_clock::now();
  program.send_signal(SIGINT);
  const ProgramResult stopped = program.wait();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(1000));
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_NE(stopped.err.find("stopped before the first level; nothing was written"), std::string::npos) << stopped.err;
  EXPECT_EQ(tmp.entries(), Words{});
}

}  // namespace
}  // namespace shellmatch
