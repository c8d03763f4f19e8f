// Runs that crash, hang or take all memory cost their own row of a study. Sanitizers catch their signals and have
// memory of their own, so that this file is not built with them.

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "tests/apps/studies/execution/study_harness.h"

namespace shellmatch {
namespace {

TEST_F(StudyProgram, WhatMisbehavesCostsItsOwnRow) {
  const std::string study = write("study.yaml", R"(version: 1
limits: {seconds: 5, grace_seconds: 0.3, memory_mb: 300}
set:
  threads: 1
  pictures: none
  input: {reference: generate:leaf/deep, template: generate:leaf/shallow, placement: as-is}
  cascade: {min_level: 3, max_level: 3}
problems:
  leaf: {set: {energy: {delta: 1}}}
solvers: [lbfgs, ceres_ncg, ceres_lbfgs, nlopt_lbfgs, nlopt_mma, newton]
)");
  const ProgramResult result =
      run_program({"study", study, "-o", path("out"), "--program", MISBEHAVING_PROGRAM, "--jobs", "2"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const CsvTable table = read_table(folder_ / "out");
  ASSERT_EQ(table.size(), 6u);
  const auto cell = [&](const char* solver, const char* column) {
    return table.at(fmt::format("leaf-{}-r1", solver)).at(column);
  };
  const auto row_is = [&](const char* solver, const char* status, const char* exit_code, const char* signal) {
    EXPECT_EQ(cell(solver, "status"), status) << solver;
    EXPECT_EQ(cell(solver, "exit_code"), exit_code) << solver;
    EXPECT_EQ(cell(solver, "signal"), signal) << solver;
    EXPECT_EQ(cell(solver, "energy"), "") << solver;
  };
  row_is("lbfgs", "crashed", "0", "11");
  row_is("ceres_ncg", "timed_out", "0", "9");
  row_is("ceres_lbfgs", "out_of_memory", "0", "9");
  row_is("nlopt_lbfgs", "failed", "9", "");
  row_is("nlopt_mma", "failed", "0", "");
  EXPECT_EQ(cell("newton", "status"), "finished");
  EXPECT_GT(std::stod(cell("newton", "energy")), 0);
  EXPECT_GE(std::stod(cell("ceres_ncg", "seconds")), 5.3);
  EXPECT_LT(std::stod(cell("ceres_ncg", "seconds")), 30);
  EXPECT_GT(std::stod(cell("ceres_lbfgs", "peak_memory_mb")), 250);
  EXPECT_LT(std::stod(cell("ceres_lbfgs", "peak_memory_mb")), 1200);
  EXPECT_EQ(cell("newton", "timings_taken"), "in parallel");

  std::ifstream summary(folder_ / "out/summary.md");
  const std::string text((std::istreambuf_iterator<char>(summary)), std::istreambuf_iterator<char>());
  EXPECT_NE(text.find("taken in parallel"), std::string::npos);
  EXPECT_NE(text.find("`leaf-lbfgs-r1`: crashed"), std::string::npos);

  // A result is a result: only what is asked for runs again, here with the build that behaves.
  EXPECT_EQ(run_program({"study", study, "-o", path("out")}).err.find("-r1 ..."), std::string::npos);
  const ProgramResult again = run_program({"study", study, "-o", path("out"), "--retry", "-q"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  for (const auto& [run, columns] : read_table(folder_ / "out")) EXPECT_EQ(columns.at("status"), "finished") << run;
}

// A full disk is no result: every further run would end likewise.
TEST_F(StudyProgram, AFullDiskEndsTheStudyAndIsNoResult) {
  const std::string study = write("study.yaml", R"(version: 1
set:
  threads: 1
  pictures: none
  input: {reference: generate:leaf/deep, template: generate:leaf/shallow, placement: as-is}
  cascade: {min_level: 3, max_level: 3}
problems: {leaf: {set: {energy: {delta: 1}}}}
solvers: [newton, fletcher_reeves]
)");
  const ProgramResult full = run_program({"study", study, "-o", path("out"), "--program", MISBEHAVING_PROGRAM});
  EXPECT_EQ(full.exit_code, 6) << full.err;
  EXPECT_TRUE(has(full.err, "leaf-fletcher_reeves-r1: error: out/history.csv")) << full.err;
  EXPECT_TRUE(has(full.err, "results so far are kept")) << full.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/runs/leaf-fletcher_reeves-r1"));
  // With room the same command goes on, without --retry.
  const ProgramResult again = run_program({"study", study, "-o", path("out")});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_FALSE(has(again.err, "leaf-newton-r1 ...")) << again.err;
  EXPECT_EQ(read_table(folder_ / "out").at("leaf-fletcher_reeves-r1").at("status"), "finished");
}

}  // namespace
}  // namespace shellmatch
