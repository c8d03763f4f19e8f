// What is wrong with a cohort, and what it costs.

#include "tests/apps/cohorts/execution/cohort_harness.h"

namespace shellmatch {
namespace {

TEST_F(CohortProgram, ADamagedSubjectIsARow) {
  const std::string file = write_cohort(4, "{kind: mean, rounds: 1}");
  write("e2.csv", "x,y\n0,zero\n");
  const ProgramResult result = cohort({file, "-o", "out"});
  ASSERT_EQ(result.exit_code, 1) << result.err;
  const std::string last = result.err.substr(result.err.rfind("shellmatch: "));
  EXPECT_TRUE(last.starts_with("shellmatch: error: 1 of 4 subjects have no result; the first is e2, failed: ")) << last;
  EXPECT_TRUE(has(last, "e2.csv, line 2") && has(last, "out/subjects.csv")) << last;
  const auto lines = csv_lines(text_of("out/subjects.csv"));
  EXPECT_TRUE(lines.at("e2").starts_with("e2,thick,failed,,,")) << lines.at("e2");
  EXPECT_TRUE(has(lines.at("e2"), "e2.csv")) << lines.at("e2");
  EXPECT_TRUE(lines.at("e1").starts_with("e1,thick,finished,matched,0,")) << lines.at("e1");
  EXPECT_TRUE(lines.at("e4").ends_with(",24")) << "further columns are kept: " << lines.at("e4");
  // Mended, it is matched; the others are not matched again in that round.
  write_ellipse("e2.csv", 1.04, 0.82);
  const ProgramResult again = cohort({file, "-o", "out"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(has(again.err, "e2 ...")) << again.err;
  EXPECT_TRUE(csv_lines(text_of("out/subjects.csv")).at("e2").starts_with("e2,thick,finished,matched,")) << again.err;
}

TEST_F(CohortProgram, AFileThatIsMissingIsRefusedBeforeAnythingRuns) {
  const std::string file = write_cohort(4, "{kind: mean, rounds: 1}");
  std::filesystem::remove(folder_ / "e3.csv");
  const ProgramResult result = cohort({file, "-o", "out"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "subject e3: ") && has(result.err, "e3.csv: no such file")) << result.err;
  EXPECT_FALSE(has(result.err, " ...")) << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(CohortProgram, OneSubjectNeedsNoRounds) {
  const std::string file = write_cohort(1, "{kind: mean, rounds: 5}");
  const ProgramResult result = cohort({file, "-o", "out"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "one subject has no mean")) << result.err;
  EXPECT_TRUE(has(result.err, "it is matched onto itself")) << result.err;
  EXPECT_FALSE(has(result.err, "round 1")) << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/report.html"));
  write_ellipse("other.csv", 1, 0.7);
  const ProgramResult other = cohort({file, "-o", "other", "--set", "atlas.shape=other.csv"});
  EXPECT_EQ(other.exit_code, 0) << other.err;
  EXPECT_TRUE(has(other.err, "one subject has no mean")) << other.err;
  EXPECT_FALSE(has(other.err, "itself")) << other.err;
}

TEST_F(CohortProgram, LandmarksThatCannotBeReadAreToldAsSuch) {
  write_cohort(2, "{}");
  write("table.csv", "id,file,landmarks\ne1,e1.csv,l1.csv\ne2,e2.csv,\n");
  const std::vector<std::string> words{
      "--table",     "table.csv",       "--atlas", "e2.csv",        "-o",
      "out",         "--levels",        "2:3",     "--set",         "landmarks=compare",
      "--set",       "align.mode=none", "--set",   "pictures=none", "--set",
      "report=false"};
  const ProgramResult missing = cohort(words);
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_TRUE(has(missing.err, "table.csv, line 2: ")) << missing.err;
  EXPECT_TRUE(has(missing.err, "l1.csv: there is no such file of landmarks")) << missing.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  write("l1.csv", "name,x,y\ntop,0,zero\n");
  const ProgramResult damaged = cohort(words);
  EXPECT_EQ(damaged.exit_code, 2);
  EXPECT_TRUE(has(damaged.err, "l1.csv, line 2")) << damaged.err;
  EXPECT_FALSE(has(damaged.err, "matched again")) << damaged.err;
  write("l1.csv", "name,x,y\ntop,0,0.86\n");
  EXPECT_EQ(cohort(words).exit_code, 0);
  // A result that is damaged is matched again.
  write("out/runs/e1/output/summary.json", "{");
  const ProgramResult torn = cohort(words);
  EXPECT_TRUE(has(torn.err, "so that it is matched again")) << torn.err;
}

TEST_F(CohortProgram, WithoutAnyUsableSubjectThereIsNoMean) {
  const std::string file = write_cohort(2, "{kind: mean, shape: good.csv}");
  write_ellipse("good.csv", 1, 0.8);
  write("e1.csv", "x,y\n0,zero\n");
  write("e2.csv", "x,y\n0,zero\n");
  const ProgramResult result = cohort({file, "-o", "out"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "no subject can be used for the mean")) << result.err;
}

TEST_F(CohortProgram, OneSubjectHasNoModes) {
  const std::string file = write_cohort(1, "{kind: given, shape: e1}");
  const ProgramResult result = cohort({file, "-o", "out"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "one subject has no modes")) << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/model/modes.npy"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/model/points.npy"));
}

TEST_F(CohortProgram, SubjectsThatDoNotDifferHaveNoModes) {
  write_ellipse("a.csv", 1, 0.8);
  write_ellipse("b.csv", 1, 0.8);
  const ProgramResult result = cohort({"a.csv", "b.csv", "--atlas", "a.csv", "-o", "out", "--levels", "2:3", "--set",
                                       "align.mode=none", "--set", "pictures=none", "--set", "report=false"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "the subjects do not differ")) << result.err;
  EXPECT_FALSE(has(result.err, "% of the variance")) << result.err;
}

TEST_F(CohortProgram, GroupsThatAreTooSmallAreNotComparedAndNothingIsLost) {
  write("table.csv",
        "id,file,group\na,generate:sphere/large,x\nb,generate:sphere/small,x\nc,generate:sphere/"
        "large,y\nd,generate:sphere/small,y\n");
  const ProgramResult result = cohort({"--table", "table.csv", "--atlas", "a", "-o", "out", "--levels", "2:2", "--set",
                                       "align.mode=none", "--set", "pictures=none", "--set", "report=false", "--set",
                                       "statistics.mode_meshes=0", "--set", "statistics.include=all"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "both together have 4 subjects in the statistics, and 5 are needed")) << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/report.html"));
}

TEST_F(CohortProgram, AFolderOfSomethingElseIsLeftAlone) {
  const std::string file = write_cohort(1, "{kind: given, shape: e1}");
  std::filesystem::create_directories(folder_ / "out");
  write("out/thesis.tex", "years of work");
  const ProgramResult result = cohort({file, "-o", "out"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "thesis.tex, which no cohort has written")) << result.err;
  EXPECT_EQ(text_of("out/thesis.tex"), "years of work");
}

TEST_F(CohortProgram, MistakesOnTheCommandLine) {
  const std::string file = write_cohort(2, "{kind: given, shape: e1}");
  const auto expect = [&](std::vector<std::string> words, const char* part) {
    const ProgramResult result = cohort(words);
    EXPECT_EQ(result.exit_code, 2) << part;
    EXPECT_TRUE(has(result.err, part)) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << part;
  };
  expect({"-o", "out"}, "no subject is named");
  expect({"e1.csv"}, "say where to write");
  expect({file, "-o", "out", "--only", "e3"}, "did you mean e1?");
  expect({file, "-o", "out", "--shard", "3/2"}, "1 <= I <= N");
  expect({file, "-o", "out", "--shard", "1/2", "--only", "e1"}, "exclude each other");
  expect({file, "-o", "out", "--stage", "1"}, "--only, --shard or --collect");
  expect({file, "-o", "out", "--jobs", "none"}, "1 to 1024");
  expect({file, "e1.csv", "-o", "out"}, "give it alone");
  expect({"nothing*.csv", "-o", "out"}, "no file has such a name");
  expect({file, "-o", "out", "--set", "atlas.kinds=mean"}, "atlas.kinds");
  expect({file, "-o", "out", "--set", "input.template=e1.csv"}, "another one for each subject");
}

}  // namespace
}  // namespace shellmatch
