// Names of volumes and of what is chosen in them.
#include "geometry/volume/volume_name.h"
#include "tests/geometry/io/files.h"

namespace shellmatch::testing {
namespace {

TEST(VolumeName, ChoosesLabelsAndThresholds) {
  const auto whole = parse_volume_name("a/scan.nii.gz"), one = parse_volume_name("scan.NRRD:3"),
             two = parse_volume_name("scan.mha:1,-2"), above = parse_volume_name("scan.nii:>0.5");
  ASSERT_TRUE(whole && one && two && above);
  EXPECT_EQ(whole->file, "a/scan.nii.gz");
  EXPECT_TRUE(whole->choice.contains(0.25f) && !whole->choice.contains(0) && !whole->choice.contains(-1));
  EXPECT_EQ(one->file, "scan.NRRD");
  EXPECT_TRUE(one->choice.contains(3) && !one->choice.contains(2) && !one->choice.contains(3.5f));
  EXPECT_TRUE(two->choice.contains(1) && two->choice.contains(-2) && !two->choice.contains(2));
  EXPECT_TRUE(above->choice.contains(0.75f) && !above->choice.contains(0.5f));
  EXPECT_EQ(one->choice.text(), "label 3");
  EXPECT_EQ(two->choice.text(), "labels 1, -2");
  EXPECT_EQ(above->choice.text(), "everything above 0.5");
}

TEST(VolumeName, AColonElsewhereBelongsToTheName) {
  EXPECT_EQ(parse_volume_name("a:b/scan:3.nii")->file, "a:b/scan:3.nii");
  EXPECT_EQ(parse_volume_name("scan:3.nii:4")->file, "scan:3.nii");
  EXPECT_EQ(file_of("scan:3.nii:4"), "scan:3.nii");
  for (const char* other : {"mesh.ply", "mesh.ply:3", "generate:hand", ".nii", "scan.gz", ""}) {
    EXPECT_FALSE(parse_volume_name(other)) << other;
    EXPECT_EQ(file_of(other), other);
  }
}

TEST(VolumeName, WhatCannotBeUnderstoodIsSaid) {
  for (const char* choice : {"", "a", "1,", ",1", "1.5", "1 2", "99999999999999999999", "16777217"})
    EXPECT_TRUE(contains(input_error_of([&] { parse_volume_name(std::string("scan.nii:") + choice); }),
                         "names no labels; write whole numbers"))
        << choice;
  for (const char* choice : {">", ">x", ">nan", ">inf"})
    EXPECT_TRUE(contains(input_error_of([&] { parse_volume_name(std::string("scan.nii:") + choice); }),
                         "is no threshold; write a number"))
        << choice;
}

}  // namespace
}  // namespace shellmatch::testing
