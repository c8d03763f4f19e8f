// A cohort's file: what it may say, and what is said of mistakes.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "apps/cohorts/cohort.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

class CohortFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("shellmatch_cohortfile_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Cohort read(const std::string& text, CohortWords words = {}) const {
    std::ofstream(folder_ / "cohort.yaml") << text;
    return read_cohort((folder_ / "cohort.yaml").string(), words);
  }
  void expect_refused(const std::string& text, std::initializer_list<const char*> parts) const {
    std::string message;
    try {
      read(text);
    } catch (const InputError& error) {
      message = error.what();
    }
    for (const char* part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << part << " is missing in: " << message;
  }
  fs::path folder_;
};

const std::string two = "version: 1\nshapes: [generate:circle, generate:ellipse]\n";

TEST_F(CohortFile, TheLeastThatRuns) {
  const Cohort cohort = read(two);
  ASSERT_EQ(cohort.subjects.size(), 2u);
  EXPECT_EQ(cohort.options.atlas.kind, AtlasKind::mean);
  EXPECT_EQ(cohort.options.atlas.shape, "circle") << "the first subject";
  EXPECT_EQ(cohort.round_level(), cohort.experiment.cascade.max_level);
}

TEST_F(CohortFile, PathsAreRelativeToTheFile) {
  fs::create_directories(folder_ / "deep");
  for (const char* name : {"atlas.ply", "a.ply", "deep/b.ply"}) std::ofstream(folder_ / name) << "a file";
  const Cohort cohort =
      read("version: 1\nshapes: [a.ply, deep/b.ply]\natlas: {kind: given, shape: atlas.ply, landmarks: points.csv}\n");
  EXPECT_EQ(cohort.subjects[1].source, (folder_ / "deep/b.ply").string());
  EXPECT_EQ(cohort.options.atlas.shape, (folder_ / "atlas.ply").string());
  EXPECT_EQ(cohort.options.atlas.landmarks, (folder_ / "points.csv").string());
}

TEST_F(CohortFile, SubjectsHaveNoPagesUnlessTheyAreAskedFor) {
  EXPECT_FALSE(read(two).experiment.report);
  EXPECT_EQ(read(two).experiment.pictures, Pictures::none);
  const Cohort asked = read(two + "set: {report: true, pictures: result}\n");
  EXPECT_TRUE(asked.experiment.report);
  const Cohort again = read(to_yaml(asked));
  EXPECT_TRUE(again.experiment.report);
  EXPECT_EQ(again.experiment.pictures, Pictures::result);
}

TEST_F(CohortFile, WhatIsWrittenIsReadBack) {
  const Cohort cohort = read(two +
                             "title: \"two: shapes\"\natlas: {kind: medoid, shape: ellipse}\nlandmarks: compare\n"
                             "statistics: {procrustes: similarity, modes: 3}\nset: {cascade: {max_level: 5}, energy: "
                             "{delta: 0.5}, solver: {fallback: []}}\n");
  const std::string text = to_yaml(cohort);
  EXPECT_NE(text.find("set:\n  cascade:\n    max_level: 5\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("sigma_cells"), std::string::npos) << "what is as by default is left out: " << text;
  const Cohort again = read(text);
  EXPECT_EQ(to_yaml(again), text);
  EXPECT_EQ(again.experiment.cascade.max_level, 5);
  EXPECT_EQ(again.options.statistics.modes, 3);
  EXPECT_EQ(again.options.atlas.shape, "ellipse");
}

TEST_F(CohortFile, TheCommandLineWins) {
  CohortWords words;
  words.overrides = {
      {"statistics.modes", "7", "--set"}, {"cascade.max_level", "6", "--set"}, {"landmarks", "compare", "--set"}};
  words.atlas = "ellipse";
  const Cohort cohort = read(two + "set: {cascade: {max_level: 5}}\n", words);
  EXPECT_EQ(cohort.options.statistics.modes, 7);
  EXPECT_EQ(cohort.experiment.cascade.max_level, 6);
  EXPECT_EQ(cohort.options.landmarks, LandmarkUse::compare);
  EXPECT_EQ(cohort.options.atlas.shape, "ellipse");
}

TEST_F(CohortFile, MistakesAreSaidWithTheirPlace) {
  expect_refused("shapes: [generate:circle]\n", {"version is missing"});
  expect_refused("version: 2\nshapes: [generate:circle]\n", {"cohort.yaml:1", "version 1 of cohort files"});
  expect_refused("version: 1\n", {"no subject is named"});
  expect_refused(two + "atlas: {knd: mean}\n", {"cohort.yaml:3", "did you mean", "kind"});
  expect_refused(two + "atlas: {kind: given}\n", {"atlas.shape", "is missing"});
  expect_refused(two + "atlas: {shape: elipse}\n", {"atlas.shape: elipse: no such file", "did you mean ellipse?"});
  expect_refused(two + "set: {cascade: {max_levels: 5}}\n", {"max_level"});
  expect_refused(two + "set: {input: {reference: a.ply}}\n", {"input.reference", "use atlas.shape"});
  expect_refused(two + "set: {start: {map: out/earlier}}\n", {"set.start.map", "leave it out"});
  expect_refused(two + "set: {start: {images: [out/earlier]}}\n", {"set.start.images", "leave it out"});
  expect_refused(two + "atlas: {max_level: 9}\nset: {cascade: {max_level: 5}}\n", {"atlas.max_level", "is 9"});
  expect_refused(two + "statistics: {groups: [a]}\n", {"two groups"});
  expect_refused(two + "statistics: {groups: [a, b]}\n", {"no subject is of the group 'a'"});
  expect_refused(two + "table: x.csv\n", {"exclude each other"});
}

TEST_F(CohortFile, EveryFileThatIsMissingIsToldAtOnce) {
  std::ofstream(folder_ / "here.ply") << "a file";
  expect_refused("version: 1\nshapes: [here.ply, lost.ply, generate:circl, scan.nii.gz:3, deep]\n",
                 {"cohort.yaml: subject lost: ", "lost.ply: no such file",
                  "subject circl: ", "subject scan_3: ", "scan.nii.gz: no such file", "subject deep: "});
  std::ofstream(folder_ / "table.csv") << "id,file\none,here.ply\ntwo,gone.ply\n";
  expect_refused("version: 1\ntable: table.csv\n",
                 {"table.csv: subject two: ", "gone.ply: no such file; check the name and the folder"});
  std::string many;
  for (int k = 0; k < 30; ++k) many += "gone" + std::to_string(k) + ".ply, ";
  expect_refused("version: 1\nshapes: [" + many + "here.ply]\n",
                 {"subject gone9: ", "and the files of 20 further subjects"});
}

TEST_F(CohortFile, TheReferenceHasEveryOption) {
  const std::string text = cohort_reference();
  for (const char* option : {"kind: mean", "procrustes: rigid", "permutations: 1000", "seconds: 0", "landmarks: match"})
    EXPECT_NE(text.find(option), std::string::npos) << option;
}

}  // namespace
}  // namespace shellmatch
