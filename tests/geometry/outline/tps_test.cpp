// TPS files as tpsDig writes them: landmarks, curves and outlines of specimens, their scale, and what is missing; what
// is written is read back.
#include "geometry/outline/tps_file.h"
#include "tests/geometry/outline/outline_files.h"

#include <limits>

namespace shellmatch::testing {
namespace {

const std::string square_points = "POINTS=4\n0 0\n10 0\n10 10\n0 10\n";

class TpsFile : public ::testing::Test {
 protected:
  Shape<2> read(const std::string& text, const std::string& part = "") const {
    return read_outline(folder_.write("wings.tps", text) + part);
  }
  std::string error(const std::string& text, const std::string& part = "") const {
    return input_error_of([&] { read(text, part); });
  }
  TempFolder folder_;
};

TEST_F(TpsFile, OutlinesOfASpecimenTimesItsScale) {
  const std::string two = "LM=2\r\n1 2\r\n3 4\r\nOUTLINES=1\r\n" + square_points +
                          "IMAGE=a wing.jpg\r\nID=a\r\nSCALE=0.5\r\n" + "LM=0\nCURVES=0\nOUTLINES=2\n" + square_points +
                          "POINTS=3\n4 4\n5 4\n4 5\nIMAGE=C:\\b.jpg\nID=7\nVARIABLES=x,y\n";
  const Shape<2> a = read(two, ":a"), b = read(two, ":7");
  EXPECT_EQ(ring(a), (Points{{0, 0}, {5, 0}, {5, 5}, {0, 5}}));
  EXPECT_TRUE(has_note(a, "coordinates multiplied by SCALE=0.5"));
  EXPECT_EQ(a.original.frame(Vec<2>(2, 4)), Vec<2>(1, 2));
  EXPECT_DOUBLE_EQ(area(b.surface), 99.5);
  EXPECT_TRUE(has_note(b, "no SCALE= where other specimens have one"));
  EXPECT_EQ(ring(read(two, ":a wing.jpg")), ring(a));
  EXPECT_EQ(ring(read(two, ":b")), ring(b));
  EXPECT_TRUE(contains(error(two), "2 specimens in it; choose one by its ID, as in"));
  EXPECT_TRUE(contains(error(two), ":a\": 'a', '7'"));
  EXPECT_TRUE(contains(error(two, ":c"), "no specimen has the ID 'c'; there are 'a', '7'"));
  EXPECT_TRUE(contains(error(two + "LM=0\nID=a\n", ":a"), "several specimens are named 'a'"));
}

TEST_F(TpsFile, CurvesThatMeetAreOneOutline) {
  const std::string parts =
      "LM=0\nCURVES=3\nPOINTS=3\n0 0\n10 0\n10 10\nPOINTS=2\n0 0\n0 5\nPOINTS=3\n10 10\n0 10\n0 5\nID=a\n";
  const Shape<2> shape = read(parts);
  EXPECT_EQ(shape.original.polygons.size(), 1u);
  EXPECT_DOUBLE_EQ(area(shape.surface), 100);
  EXPECT_TRUE(has_note(shape, "3 curves joined where they meet"));
  EXPECT_FALSE(has_note(shape, "open path"));
  // In the middle of the chain is begun.
  EXPECT_DOUBLE_EQ(area(read("CURVES=3\nPOINTS=2\n10 0\n10 10\nPOINTS=2\n0 0\n10 0\nPOINTS=2\n10 10\n0 10\n").surface),
                   100);
  const Shape<2> open = read("CURVES=1\n" + square_points);
  EXPECT_TRUE(has_note(open, "1 open path closed by a line"));
  EXPECT_DOUBLE_EQ(area(open.surface), 100);
}

TEST_F(TpsFile, SpecimensWithoutLandmarksBeginWhereAWordComesAgain) {
  const std::string two = "OUTLINES=1\n" + square_points + "ID=a\nOUTLINES=1\n" + square_points + "SCALE=2\nID=b\n";
  EXPECT_DOUBLE_EQ(area(read(two, ":a").surface), 100);
  EXPECT_DOUBLE_EQ(area(read(two, ":b").surface), 400);
  EXPECT_EQ(parse_tps("a", "ID=a\nIMAGE=b\nID=c").size(), 2u);
  EXPECT_EQ(parse_tps("a", "IMAGE=a\nIMAGE=b\nLM=0\nRADII=2\n1\n2\nCURVES=0\nOUTLINES=0\nCOMMENT=b").size(), 3u);
}

TEST_F(TpsFile, LandmarksAndTheirFrame) {
  const std::vector<TpsSpecimen> read = parse_tps("a.tps", "LM3=2\n1 2 3\nNA NA NA\nID=a\nCOMMENT=SPACE=LPS\n");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].space, Space::lps);
  const auto points = scaled_landmarks<3>(read[0], "a.tps");
  EXPECT_EQ(points[0], Vec<3>(1, 2, 3));
  EXPECT_FALSE(points[1]);
  EXPECT_TRUE(contains(input_error_of([&] { scaled_landmarks<2>(read[0], "a.tps"); }), "LM3= holds points of space"));
}

TEST_F(TpsFile, WhatIsWrittenIsReadBack) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::string text;
  append_tps_specimen(text, "first\none", std::vector<double>{1e-17, -2.5, nan, nan, 1.0 / 3, 4e30}, 2);
  append_tps_specimen(text, "b", std::vector<double>{1, 2, 3, 4, 5, 6}, 3, Space::ras);
  const std::vector<TpsSpecimen> read = parse_tps("a.tps", text);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].id, "first one");
  EXPECT_TRUE(contains(text, "\nNA NA\n")) << "as geomorph reads it";
  const auto plane = scaled_landmarks<2>(read[0], "a");
  EXPECT_EQ(plane[0], Vec<2>(1e-17, -2.5));
  EXPECT_FALSE(plane[1]);
  EXPECT_EQ(plane[2], Vec<2>(1.0 / 3, 4e30));
  EXPECT_EQ(read[1].space, Space::ras);
  EXPECT_EQ(scaled_landmarks<3>(read[1], "a")[1], Vec<3>(4, 5, 6));
}

TEST_F(TpsFile, LandmarksAloneArePointsAndNoOutline) {
  const std::string text = "LM=3\n1 2\nNA NA\n3 4\nSCALE=2\n";
  EXPECT_TRUE(contains(error(text), "no outline; landmarks are for --landmarks"));
  std::vector<std::string> notes;
  const OriginalShape<2> points = read_points_or_outline_2d(folder_.path("wings.tps"), &notes);
  EXPECT_EQ(points.vertices, (Points{{2, 4}, {6, 8}}));
  EXPECT_EQ(points.attributes.at(0).texts, (std::vector<std::string>{"1", "3"}));
  EXPECT_EQ(notes,
            (std::vector<std::string>{"1 landmark without position left out", "coordinates multiplied by SCALE=2"}));
  const OriginalShape<3> space = read_points_or_mesh_3d(
      folder_.write("b.tps", "LM3=1\n1 2 3\nID=a\nLM3=1\n4 5 6\nID=b\nCOMMENT=SPACE=RAS\n") + ":b");
  EXPECT_EQ(space.vertices.at(0), Vec<3>(4, 5, 6));
  EXPECT_EQ(space.space, Space::ras);
}

TEST_F(TpsFile, WhatIsWrongIsSaidWithItsLine) {
  EXPECT_TRUE(contains(error("1 2\n"), "line 1: no TPS file"));
  EXPECT_TRUE(contains(error("LM=2\n1 2\nID=a\n"), "line 3: landmark 2 of 2 is missing"));
  EXPECT_TRUE(contains(error("LM=1\n1 2\n3 4\n"), "line 3: a line of numbers that no LM= or POINTS= announces"));
  EXPECT_TRUE(contains(error("LM=1\n1,5 2,5\n"), "'1,5' is no number; landmark has 2 with '.'"));
  EXPECT_TRUE(contains(error("LM=1\n1 5 2\n"), "more numbers than the 2"));
  EXPECT_TRUE(contains(error("LM=1\n1 a\n"), "'a' is no number"));
  EXPECT_TRUE(contains(error("LM=1\n1 NA\n"), "one coordinate is missing"));
  EXPECT_TRUE(contains(error("LM=x\n"), "LM is 'x'"));
  EXPECT_TRUE(contains(error("LM=0\nSCALE=0\n"), "SCALE is '0'"));
  EXPECT_TRUE(contains(error("LM=0\n" + square_points), "neither CURVES= nor OUTLINES= announces"));
  EXPECT_TRUE(contains(error("LM=0\nCURVES=2\n" + square_points), "1 of 2 announced curves are there"));
  EXPECT_TRUE(contains(error("OUTLINES=1\nPOINTS=4\n0 0\n1 0\n"), "point 3 of 4 is missing"));
  EXPECT_TRUE(contains(error("OUTLINES=1\nPOINTS=1\nNA NA\n"), "a point of a curve is missing"));
  EXPECT_TRUE(contains(error("LM=0\nLM=0\n"), "give each an ID="));
  EXPECT_TRUE(contains(error("\n"), "no specimen"));
}

}  // namespace
}  // namespace shellmatch::testing
