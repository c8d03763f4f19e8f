// Whose files are whose in a cohort's folder: none of the user's is lost, none of an earlier run is left.

#include "tests/cohorts/execution/cohort_harness.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

struct CohortFiles : CohortProgram {
  bool exists(const std::string& name) const { return fs::exists(folder_ / name); }
};

TEST_F(CohortFiles, ThoseOfTheUserStay) {
  const std::string file = write_cohort(3, "{kind: given, shape: e1}");
  ASSERT_EQ(cohort({file, "-o", "out"}).exit_code, 0);
  fs::create_directories(folder_ / "out/model/mine");
  const std::vector<std::string> mine{"out/model/mode_notes.txt", "out/model/mode_1.png", "out/model/mode_1_plus_smoothed.csv", "out/model/mode_1.webp.bak",
                                      "out/model/notes.txt", "out/model/mine/a.txt", "out/landmarks.csv", "out/landmarks_on_atlas.csv", "out/atlas_landmarks.csv"};
  for (const std::string& name : mine) write(name, "years of work");
  ASSERT_EQ(cohort({file, "-o", "out"}).exit_code, 0);
  for (const std::string& name : mine) EXPECT_EQ(exists(name) ? text_of(name) : "", "years of work") << name;
  // Nor where no subject is used.
  for (const char* name : {"e1.csv", "e2.csv", "e3.csv"}) write(name, "x,y\n0,zero\n");
  write_ellipse("good.csv", 1, 0.8);
  cohort({write_cohort(3, "{kind: given, shape: good.csv}"), "-o", "out"});
  for (const std::string& name : mine) EXPECT_EQ(exists(name) ? text_of(name) : "", "years of work") << name;
}

TEST_F(CohortFiles, ThoseOfAnEarlierRunGo) {
  write_cohort(3, "{kind: given, shape: e1}");
  write("points.csv", "name,vertex\na,0\nb,20\n");
  const std::vector<std::string> options{"-o", "out", "--atlas", "e1.csv", "--levels", "2:3", "--set", "align.mode=none", "--set", "pictures=none", "--set", "report=false"};
  std::vector<std::string> three{"e1.csv", "e2.csv", "e3.csv", "--atlas-landmarks", "points.csv"}, one{"e2.csv"};
  three.insert(three.end(), options.begin(), options.end());
  one.insert(one.end(), options.begin(), options.end());
  ASSERT_EQ(cohort(three).exit_code, 0);
  const std::vector<std::string> statistics{"out/model/modes.npy", "out/model/modes.csv", "out/model/scores.csv", "out/model/mean.csv", "out/model/mode_1_plus.csv",
                                            "out/landmarks.csv", "out/atlas_landmarks.csv"};
  for (const std::string& name : statistics) EXPECT_TRUE(exists(name)) << name;
  ASSERT_EQ(cohort(one).exit_code, 0);
  for (const std::string& name : statistics) EXPECT_FALSE(exists(name)) << name << " is of three subjects";
  EXPECT_TRUE(exists("out/model/points.npy"));
}

TEST_F(CohortFiles, AnInputThatTheResultWouldReplaceIsRefused) {
  const std::string file = write_cohort(2, "{kind: given, shape: e1}");
  ASSERT_EQ(cohort({file, "-o", "out"}).exit_code, 0);
  for (const char* input : {"out/model/mode_1_plus.csv", "out/atlas.csv"}) {
    const std::string before = text_of(input);
    const ProgramResult result = cohort({"e1.csv", "e2.csv", "-o", "out", "--levels", "2:3", "--atlas", input});
    EXPECT_EQ(result.exit_code, 2) << input;
    EXPECT_TRUE(has(result.err, input) && has(result.err, "copy it elsewhere")) << result.err;
    EXPECT_EQ(text_of(input), before);
  }
}

TEST_F(CohortFiles, ADescriptionWithoutRunsIsSomebodys) {
  write_cohort(2, "{kind: given, shape: e1}");
  fs::create_directories(folder_ / "out");
  write("out/cohort.yaml", "mine");
  const ProgramResult result = cohort({"e1.csv", "e2.csv", "-o", "out", "--levels", "2:3"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "describes another cohort")) << result.err;
  EXPECT_EQ(text_of("out/cohort.yaml"), "mine");
  EXPECT_FALSE(exists("out/runs"));
}

}  // namespace
}  // namespace shellmatch
