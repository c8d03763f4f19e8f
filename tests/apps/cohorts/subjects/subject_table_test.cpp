// Tables and patterns of subjects.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "apps/cohorts/subjects/subject_table.h"

namespace shellmatch {
namespace {

namespace fs = std::filesystem;

class SubjectTable : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("shellmatch_subjects_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& text) const {
    std::ofstream(folder_ / "table.csv", std::ios::binary) << text;
    return (folder_ / "table.csv").string();
  }
  std::string refusal(const std::string& text) const {
    try {
      read_subject_table(write(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  fs::path folder_;
};

TEST_F(SubjectTable, ColumnsMayStandInAnyOrderAndOthersAreKept) {
  const auto subjects = read_subject_table(write(
      "group,File,reflect,age,id\r\nfemale,scans/a.ply,Yes,\"7, about\",first\r\n\r\nmale,/abs/b.nii.gz:3,0,8,\r\n"));
  ASSERT_EQ(subjects.size(), 2u);
  EXPECT_EQ(subjects[0].id, "first");
  EXPECT_EQ(subjects[0].source, (folder_ / "scans/a.ply").string());
  EXPECT_EQ(subjects[0].group, "female");
  EXPECT_TRUE(subjects[0].reflect);
  EXPECT_EQ(subjects[0].further, (std::vector<std::pair<std::string, std::string>>{{"age", "7, about"}}));
  EXPECT_EQ(subjects[1].id, "b_3");
  EXPECT_EQ(subjects[1].source, "/abs/b.nii.gz:3");
  EXPECT_FALSE(subjects[1].reflect);
}

TEST_F(SubjectTable, MistakesAreSaidWithTheirLine) {
  EXPECT_NE(refusal("id,group\na,b\n").find("line 1: there is no column 'file'"), std::string::npos);
  EXPECT_NE(refusal("file,reflect\na.ply,perhaps\n").find("line 2: reflect is 'perhaps'"), std::string::npos);
  EXPECT_NE(refusal("file,id\na.ply\n").find("line 2: 1 values where the head line has 2"), std::string::npos);
  EXPECT_NE(refusal("file,file\na,b\n").find("two columns"), std::string::npos);
  EXPECT_NE(refusal("file,id\n,a\n").find("line 2: the name of the file is empty"), std::string::npos);
  EXPECT_NE(refusal("file\n").find("no subject"), std::string::npos);
  EXPECT_NE(refusal("file\na/s.ply\nb/s.ply\n").find("lines 2 and 3: two subjects have the id s"), std::string::npos);
  const std::string equal = refusal("id,file\nx,a.ply\ny,b.ply\n\nx,c.ply\n");
  EXPECT_NE(equal.find("lines 2 and 5: two subjects have the id x"), std::string::npos) << equal;
  EXPECT_NE(equal.find("ids must differ"), std::string::npos) << equal;
  EXPECT_EQ(equal.find("give them ids in a table"), std::string::npos) << equal;
  EXPECT_NE(refusal("file,id\na.ply,../up\n").find("cannot be the name of a folder"), std::string::npos);
  EXPECT_NE(refusal("file\na/hand/\n").find("the id '' cannot be the name of a folder"), std::string::npos);
  EXPECT_NE(refusal("file,id\na.ply,.hidden\n").find("cannot be the name of a folder"), std::string::npos);
}

TEST_F(SubjectTable, PatternsGiveFilesInTheOrderOfTheirNames) {
  for (const char* name : {"s10.ply", "s2.ply", "t1.ply"}) std::ofstream(folder_ / name) << "x";
  const auto subjects = subjects_of({(folder_ / "s*.ply").string(), "generate:hand/bent"}, "cohort");
  ASSERT_EQ(subjects.size(), 3u);
  EXPECT_EQ(subjects[0].id, "s10");
  EXPECT_EQ(subjects[1].id, "s2");
  EXPECT_EQ(subjects[2].id, "hand_bent");
  EXPECT_EQ(subjects[2].source, "generate:hand/bent");
  EXPECT_THROW(subjects_of({(folder_ / "u*.ply").string()}, "cohort"), InputError);
}

}  // namespace
}  // namespace shellmatch
