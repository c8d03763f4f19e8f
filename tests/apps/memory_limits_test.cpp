// --max-memory where little is given: sanitizers have memory of their own, so that this file is not built with them.

#include "apps/process/limits.h"
#include "matching/output/summary.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

Words match(const std::string& out, const std::string& levels) {
  return {"match",
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
          "pictures=none",
          "--max-memory",
          "180MB"};
}

TEST(MemoryLimits, ALevelThatDoesNotFitIsNotBegun) {
  const TemporaryFolder tmp;
  const ProgramResult stopped = run_program(match(tmp / "o", "3:7"));
  EXPECT_EQ(stopped.exit_code, 4) << stopped.err;
  const std::string told = last_line(stopped.err);
  EXPECT_TRUE(has(told, "--max-memory 180MB does not suffice: level ") && has(told, " would need about ") &&
              has(told, "give more"))
      << told;
  EXPECT_TRUE(has(told, "is kept in")) << told;
  EXPECT_FALSE(fs::exists(tmp / "o"));
  const MatchSummary kept = read_summary(tmp / "o.unfinished/summary.json");
  EXPECT_LT(kept.run.peak_memory_bytes, 180000000u);
  ASSERT_TRUE(kept.run.level_memory_estimates && kept.run.level_memory_peaks);
  EXPECT_EQ(kept.run.level_memory_estimates->size(), kept.levels.size());
  // What cannot suffice for any level is refused before the first.
  const ProgramResult refused = run_program(match(tmp / "p", "3:9"));
  EXPECT_EQ(refused.exit_code, 4) << refused.err;
  EXPECT_TRUE(has(refused.err, "level 9 would need at least") && has(refused.err, "nothing was written"))
      << refused.err;
}

TEST(MemoryLimits, ResidentMemoryIsWatchedWhereNothingIsForeseen) {
  const TemporaryFolder tmp;
  const ProgramResult result =
      run_program({"generate", "hand", "-o", tmp / "h.ply", "--edge-length", "0.003", "--max-memory", "30MB"});
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_TRUE(has(result.err, "--max-memory 30MB does not suffice: stopped; nothing was written")) << result.err;
  EXPECT_EQ(tmp.entries(), Words{});
}

// In a process of its own.
TEST(MemoryLimits, AllocationsFarBeyondFail) {
  const auto allocate = [](const std::string& limit) {
    const KeptLimits limits({"", limit}, KeptLimits::Memory::of_process);
    try {
      std::vector<char> large(std::size_t{1} << 30);
      static volatile char* used;  // g++ 16 leaves out what nobody can see
      used = large.data();
      _exit(*used == 0 ? 0 : 2);
    } catch (const std::bad_alloc&) {
      _exit(1);
    }
  };
  EXPECT_EXIT(allocate("4GB"), ::testing::ExitedWithCode(0), "");
  EXPECT_EXIT(allocate("100MB"), ::testing::ExitedWithCode(1), "");
}

}  // namespace
}  // namespace shellmatch
