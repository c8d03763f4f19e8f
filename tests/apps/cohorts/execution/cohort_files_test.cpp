// Whose files are whose in a cohort's folder: none of the user's is lost, none of an earlier run is left.

#include "tests/apps/cohorts/execution/cohort_harness.h"

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
  const std::vector<std::string> mine{
      "out/model/mode_notes.txt",   "out/model/mode_1.png",   "out/model/mode_1_plus_smoothed.csv",
      "out/model/mode_1.webp.bak",  "out/model/notes.txt",    "out/model/mine/a.txt",
      "out/landmarks.csv",          "out/landmarks.tps",      "out/landmarks.txt",
      "out/landmarks_on_atlas.csv", "out/atlas_landmarks.csv"};
  for (const std::string& name : mine) write(name, "years of work");
  fs::create_symlink(folder_ / "e1.csv", folder_ / "out/model/mode_9.webp");
  ASSERT_EQ(cohort({file, "-o", "out"}).exit_code, 0);
  for (const std::string& name : mine) EXPECT_EQ(exists(name) ? text_of(name) : "", "years of work") << name;
  EXPECT_TRUE(fs::is_symlink(folder_ / "out/model/mode_9.webp")) << "the program makes no links";
  // Nor where no subject is used.
  write_cohort(3, "{kind: given, shape: good.csv}");
  for (const char* name : {"e1.csv", "e2.csv", "e3.csv"}) write(name, "x,y\n0,zero\n");
  write_ellipse("good.csv", 1, 0.8);
  const ProgramResult none = cohort({file, "-o", "out"});
  EXPECT_TRUE(has(none.err, "no subject can be used for statistics")) << none.err;
  EXPECT_FALSE(exists("out/model/points.npy"));
  for (const std::string& name : mine) EXPECT_EQ(exists(name) ? text_of(name) : "", "years of work") << name;
}

TEST_F(CohortFiles, ThoseOfAnEarlierRunGo) {
  write_cohort(3, "{kind: given, shape: e1}");
  write("points.csv", "name,vertex\na,0\nb,20\n");
  const std::vector<std::string> options{"-o",       "out",           "--atlas", "e1.csv",
                                         "--levels", "2:3",           "--set",   "align.mode=none",
                                         "--set",    "pictures=none", "--set",   "report=false"};
  std::vector<std::string> three{"e1.csv", "e2.csv", "e3.csv", "--atlas-landmarks", "points.csv"}, one{"e2.csv"};
  three.insert(three.end(), options.begin(), options.end());
  one.insert(one.end(), options.begin(), options.end());
  ASSERT_EQ(cohort(three).exit_code, 0);
  const std::vector<std::string> statistics{
      "out/model/modes.npy", "out/model/modes.csv",       "out/model/scores.csv",
      "out/model/mean.csv",  "out/model/mode_1_plus.csv", "out/landmarks.csv",
      "out/landmarks.tps",   "out/landmarks.txt",         "out/atlas_landmarks.csv"};
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

TEST_F(CohortFiles, TablesAndLinksAreInputsAsWell) {
  const std::string file = write_cohort(2, "{kind: given, shape: e1}");
  ASSERT_EQ(cohort({file, "-o", "out"}).exit_code, 0);
  write("points.csv", "name,vertex\na,0\n");
  write("out/landmarks.csv", "name,vertex\na,0\n");
  fs::create_directories(folder_ / "out/model/mine");
  fs::copy_file(folder_ / "e1.csv", folder_ / "out/model/mine/atlas.csv");
  fs::create_directory_symlink(folder_ / "out", folder_ / "link");
  fs::create_symlink(folder_ / "points.csv", folder_ / "out/atlas_landmarks.csv");
  const auto refused = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"-o", "out", "--levels", "2:3", "--atlas", "e1.csv"});
    const ProgramResult result = cohort(words);
    EXPECT_EQ(result.exit_code, 2) << words[1];
    EXPECT_TRUE(has(result.err, "copy it elsewhere")) << words[1] << result.err;
  };
  refused({"--table", "out/subjects.csv"});
  refused({"e1.csv", "link/atlas.csv"});
  refused({"e1.csv", "e2.csv", "--atlas-landmarks", "out/landmarks.csv"});
  refused({"e1.csv", "e2.csv", "--atlas-landmarks", "out/atlas_landmarks.csv"});
  EXPECT_TRUE(fs::is_symlink(folder_ / "out/atlas_landmarks.csv"));
  // A file that the program does not write may lie there.
  const ProgramResult result =
      cohort({"e1.csv", "e2.csv", "-o", "out", "--levels", "2:3", "--set", "align.mode=none", "--set", "pictures=none",
              "--set", "report=false", "--atlas", "out/model/mine/atlas.csv"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(CohortFiles, ThoseOfAnotherDimensionGo) {
  write_cohort(2, "{}");
  write("solid.csv", "name,vertex\na,0\n");
  const std::vector<std::string> options{
      "-o",    "out",           "--levels", "2:2",          "--set", "align.mode=none",
      "--set", "pictures=none", "--set",    "report=false", "--set", "statistics.include=all"};
  std::vector<std::string> solid{"generate:sphere/large", "generate:sphere/small", "--atlas",
                                 "generate:sphere/large", "--atlas-landmarks",     "solid.csv"},
      planar{"e1.csv", "e2.csv", "--atlas", "e1.csv"};
  solid.insert(solid.end(), options.begin(), options.end());
  planar.insert(planar.end(), options.begin(), options.end());
  const ProgramResult first = cohort(solid);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const std::vector<std::string> of_spheres{"out/model/mean.ply", "out/model/mean.vtp", "out/model/mode_1_plus.ply",
                                            "out/landmarks.csv", "out/atlas_landmarks.csv"};
  for (const std::string& name : of_spheres) EXPECT_TRUE(exists(name)) << name;
  const ProgramResult second = cohort(planar);
  ASSERT_EQ(second.exit_code, 0) << second.err;
  for (const std::string& name : of_spheres) EXPECT_FALSE(exists(name)) << name;
  EXPECT_TRUE(exists("out/model/mean.csv"));
}

TEST_F(CohortFiles, ADescriptionWithoutRunsIsSomebodys) {
  write_cohort(2, "{kind: given, shape: e1}");
  fs::create_directories(folder_ / "out");
  write("out/cohort.yaml", "mine");
  const ProgramResult result = cohort({"e1.csv", "e2.csv", "-o", "out", "--levels", "2:3"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "out/cohort.yaml: is not replaced")) << result.err;
  EXPECT_EQ(text_of("out/cohort.yaml"), "mine");
  EXPECT_FALSE(exists("out/runs"));
  // Nor is one that was edited after a run; the program's own copy is.
  const std::vector<std::string> words{"cohort.yaml", "-o", "own", "-q"};
  ASSERT_EQ(cohort(words).exit_code, 0);
  const std::string copy = text_of("own/cohort.yaml");
  write_cohort(2, "{kind: given, shape: e2}");
  ASSERT_EQ(cohort(words).exit_code, 0);
  EXPECT_NE(text_of("own/cohort.yaml"), copy);
  write("own/cohort.yaml", "# my notes\n" + copy);
  EXPECT_EQ(cohort(words).exit_code, 2);
  EXPECT_EQ(text_of("own/cohort.yaml"), "# my notes\n" + copy);
}

}  // namespace
}  // namespace shellmatch
