// A cohort in parts: shards, single subjects, stages and what closes them; kills.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "tests/cohorts/execution/cohort_harness.h"

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
