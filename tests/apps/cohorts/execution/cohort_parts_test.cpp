// A cohort in parts: shards, single subjects, stages and what closes them; kills.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "tests/apps/cohorts/execution/cohort_harness.h"

namespace shellmatch {
namespace {

TEST_F(CohortProgram, ShardsAndCollectionGiveTheSameFiles) {
  const std::string file = write_cohort(3, "{kind: mean, rounds: 2, tolerance: 0}");
  ASSERT_EQ(cohort({file, "-o", "whole", "-q"}).exit_code, 0);
  for (int stage = 0; stage < 3; ++stage) {
    const ProgramResult early = cohort({file, "-o", "parts", "--collect"});
    if (stage < 2) {
      EXPECT_EQ(early.exit_code, 2) << early.err;
      EXPECT_TRUE(has(early.err, fmt::format("round {}: 3 of 3 subjects have no result yet", stage + 1))) << early.err;
    }
    for (const char* shard : {"1/2", "2/2"}) {
      const ProgramResult part = cohort({file, "-o", "parts", "--shard", shard});
      EXPECT_EQ(part.exit_code, 0) << part.err;
    }
    if (stage < 2) {
      EXPECT_EQ(cohort({file, "-o", "parts", "--collect", "--stage", std::to_string(stage + 1), "-q"}).exit_code, 0);
    }
  }
  ASSERT_EQ(cohort({file, "-o", "parts", "--collect", "-q"}).exit_code, 0);
  EXPECT_EQ(lasting_files("parts"), lasting_files("whole"));
}

TEST_F(CohortProgram, PartsMatchWhatIsNewOrChangedInAClosedRound) {
  const std::string file = write_cohort(3, "{kind: mean, rounds: 1}");
  ASSERT_EQ(cohort({file, "-o", "parts", "-q"}).exit_code, 0);
  write_ellipse("e4.csv", 1.1, 0.7);
  write("table.csv", text_of("table.csv") + "e4,e4.csv,thin,24\n");
  write_ellipse("e3.csv", 1.05, 0.85);
  for (const char* shard : {"1/2", "2/2"}) {
    const ProgramResult part = cohort({file, "-o", "parts", "--shard", shard});
    EXPECT_EQ(part.exit_code, 0) << part.err;
    EXPECT_TRUE(has(part.err, shard[0] == '1' ? "e3: finished" : "e4: finished")) << part.err;
    EXPECT_FALSE(has(part.err, shard[0] == '1' ? "e1: finished" : "e2: finished")) << part.err;
  }
  ASSERT_EQ(cohort({file, "-o", "parts", "--collect", "--stage", "1", "-q"}).exit_code, 0);
  // A file that changes once the round is closed is matched again in it, too.
  write_ellipse("e2.csv", 1.06, 0.8);
  const ProgramResult changed = cohort({file, "-o", "parts", "--only", "e2", "--stage", "1"});
  EXPECT_TRUE(has(changed.err, "e2: finished")) << changed.err;
  for (const char* stage : {"1", "last"}) {
    ASSERT_EQ(cohort({file, "-o", "parts", "--shard", "1/1", "--stage", stage, "-q"}).exit_code, 0);
    const ProgramResult closed = cohort({file, "-o", "parts", "--collect", "--stage", stage, "-q"});
    ASSERT_EQ(closed.exit_code, 0) << closed.err;
  }
  ASSERT_EQ(cohort({file, "-o", "whole", "-q"}).exit_code, 0);
  EXPECT_EQ(text_of("parts/model/scores.csv"), text_of("whole/model/scores.csv"));
}

TEST_F(CohortProgram, ALimitOrTitleOpensNoRoundAgain) {
  const std::string file = write_cohort(2, "{kind: mean, rounds: 1}");
  ASSERT_EQ(cohort({file, "-o", "out", "--shard", "1/1", "-q"}).exit_code, 0);
  ASSERT_EQ(cohort({file, "-o", "out", "--collect", "--stage", "1", "-q"}).exit_code, 0);
  const ProgramResult part = cohort({file, "-o", "out", "--only", "e1", "--max-memory", "2GB", "--set", "title=Ovals",
                                     "--set", "statistics.samples=60"});
  EXPECT_EQ(part.exit_code, 0) << part.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/runs/e1")) << "the last stage: " << part.err;
}

TEST_F(CohortProgram, ALimitOfMemoryThatNoSubjectKeepsEndsIt) {
  for (const char* atlas : {"{kind: mean, rounds: 1}", "{kind: given, shape: e1.csv}"}) {
    const std::string file = write_cohort(2, atlas);
    const ProgramResult ended = cohort({file, "-o", "small", "-q", "--max-memory", "2MB"});
    EXPECT_EQ(ended.exit_code, 4) << ended.err;
    EXPECT_TRUE(has(ended.err, "--max-memory 2MB does not suffice: ")) << ended.err;
    std::filesystem::remove_all(folder_ / "small");
  }
}

TEST_F(CohortProgram, AMedoidThatIsNoLongerASubjectIsNamed) {
  const std::string file = write_cohort(3, "{kind: medoid, shape: e1}");
  ASSERT_EQ(cohort({file, "-o", "out", "-q"}).exit_code, 0);
  std::string record = text_of("out/atlas/round_1/round.json");
  const std::size_t at = record.find("\"nearest\"");
  ASSERT_NE(at, std::string::npos);
  record.replace(record.find('e', at + 9), 2, "e9");
  write("out/atlas/round_1/round.json", record);
  const ProgramResult part = cohort({file, "-o", "out", "--only", "e1", "--stage", "last"});
  EXPECT_EQ(part.exit_code, 2) << part.err;
  EXPECT_TRUE(has(part.err, "e9 is the medoid and no longer a subject")) << part.err;
}

TEST_F(CohortProgram, ASubjectNamedTwiceIsMatchedOnce) {
  const std::string file = write_cohort(2, "{kind: given, shape: e1}");
  const ProgramResult part = cohort({file, "-o", "out", "--only", "e1", "--only", "e1", "--jobs", "2"});
  EXPECT_EQ(part.exit_code, 0) << part.err;
  EXPECT_TRUE(has(part.err, "last stage: 1 subject")) << part.err;
}

TEST_F(CohortProgram, AStageWaitsForTheOneBefore) {
  const std::string file = write_cohort(2, "{kind: mean, rounds: 2, tolerance: 0}");
  const ProgramResult early = cohort({file, "-o", "out", "--only", "e1", "--stage", "last"});
  EXPECT_EQ(early.exit_code, 2);
  EXPECT_TRUE(has(early.err, "last stage waits for round 1")) << early.err;
  EXPECT_EQ(cohort({file, "--list-stages"}).out, "1\n2\nlast\n");
  EXPECT_EQ(cohort({file, "--list"}).out, "e1\ne2\n");
}

TEST_F(CohortProgram, RoundsAfterTheSearchHasEndedAreNothingToDo) {
  const std::string file = write_cohort(2, "{kind: mean, rounds: 5, tolerance: 50}");
  ASSERT_EQ(cohort({file, "-o", "out", "-q"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/atlas/round_2"));
  const ProgramResult later = cohort({file, "-o", "out", "--only", "e1", "--stage", "3"});
  EXPECT_EQ(later.exit_code, 0) << later.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/atlas/round_3"));
}

TEST_F(CohortProgram, KilledAtRandomItGoesOnToTheSameFiles) {
  const std::string file = write_cohort(4, "{kind: mean, rounds: 2, tolerance: 0}");
  ASSERT_EQ(cohort({file, "-o", "whole", "-q"}).exit_code, 0);
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(fmt::format("seed {}", seed));
  std::mt19937 random(seed);
  for (int k = 0; k < 6; ++k) {
    Program program({"cohort", file, "-o", path("torn"), "-q"});
    std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution<>(20, 900)(random)));
    program.send_signal(SIGKILL);
    program.wait();
  }
  const ProgramResult end = cohort({file, "-o", "torn"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(lasting_files("torn"), lasting_files("whole"));
}

}  // namespace
}  // namespace shellmatch
