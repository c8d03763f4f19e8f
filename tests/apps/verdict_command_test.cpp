// What a run says of its result, and --fail-on.

#include "matching/output/summary.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace shellmatch {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

Words match(const char* reference, const char* template_shape, const std::string& out, const Words& more) {
  Words words{"match",   reference, template_shape, "-o",           out, "--levels", "3:4",
              "--align", "none",    "--set",        "pictures=none"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(VerdictCommand, AGoodPairPassesAndIsSaidToMatchInItsUnit) {
  const TemporaryFolder tmp;
  const ProgramResult run = run_program(
      match("generate:circle", "generate:ellipse", tmp / "o", {"--fail-on", "look-here", "--set", "input.unit=mm"}));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(has(run.err, "verdict: matched\n")) << run.err;
  EXPECT_TRUE(has(run.err, " mm (")) << run.err;
  const MatchSummary s = read_summary(tmp / "o/summary.json");
  EXPECT_EQ(s.verdict.value().outcome, "matched");
  EXPECT_EQ(s.unit, "mm");
  EXPECT_NEAR(s.template_diagonal.value(), 0.6 * std::sqrt(2.0), 1e-4);  // of a circle of radius 0.3
  EXPECT_EQ(s.reference.n_components, 1u);
}

TEST(VerdictCommand, AWrongPairFailsOnRequestAndKeepsItsResult) {
  const TemporaryFolder tmp;
  const ProgramResult run =
      run_program(match("generate:torus", "generate:box", tmp / "o", {"-q", "--fail-on", "look-here"}));
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_TRUE(has(last_line(run.err), "o: the verdict is ") && has(last_line(run.err), "(--fail-on look-here): "))
      << run.err;
  const MatchSummary s = read_summary(tmp / "o/summary.json");
  ASSERT_NE(s.verdict.value().outcome, "matched");
  bool says_genus = false;
  for (const VerdictReason& reason : s.verdict->reasons)
    says_genus = says_genus || has(reason.what, "the reference has 1 component and genus 1, the template 1 and 0");
  EXPECT_TRUE(says_genus);
  EXPECT_EQ(run_program(match("generate:torus", "generate:box", tmp / "p", {"-q"})).exit_code, 0);
}

TEST(VerdictCommand, AnUnknownVerdictIsRefusedBeforeTheRun) {
  const TemporaryFolder tmp;
  const ProgramResult run = run_program(match("generate:circle", "generate:ellipse", tmp / "o", {"--fail-on", "bad"}));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(has(run.err, "--fail-on bad: expected look-here or not-matched")) << run.err;
  EXPECT_FALSE(fs::exists(tmp / "o"));
}

}  // namespace
}  // namespace shellmatch
