// Files of landmarks: what they say, and what is wrong with them in one line that names file and line.

#include "base/error.h"
#include "matching/pairs/landmark_file.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::message_of;
using testing::put;
using testing::TemporaryFolder;

const std::vector<Vec<3>> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const std::vector<Vec<3>> others = {{5, 5, 5}, {6, 6, 6}};

struct LandmarkFile : ::testing::Test {
  TemporaryFolder folder;
  LandmarkOptions options;

  std::vector<Landmark<3>> read(const std::string& text, const std::string& of_template = "") {
    options.file = folder / "a.csv";
    put(options.file, text);
    options.template_file = of_template.empty() ? "" : folder / "b.csv";
    if (!of_template.empty()) put(options.template_file, of_template);
    return read_landmarks<3>(options, corners, others);
  }
  void expect_refused(const std::string& place, const std::string& why, const std::string& text,
                      const std::string& of_template = "") {
    const std::string message = message_of<InputError>([&] { read(text, of_template); });
    EXPECT_EQ(message.find(folder / place), 0u) << message;
    EXPECT_NE(message.find(why), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
};

TEST_F(LandmarkFile, HoldsPointsOfBothShapes) {
  const auto marks =
      read("# ours\nname, x1,y1,z1, x2,y2,z2, weight\nnose,1,2,3,4,5,6,0.5\n\n\"left ear\",-1e-1,0,0,0,0,7,2\n");
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[0].name, "nose");
  EXPECT_EQ(marks[0].on_reference, Vec<3>(1, 2, 3));
  EXPECT_EQ(marks[0].on_template, Vec<3>(4, 5, 6));
  EXPECT_EQ(marks[0].weight, 0.5);
  EXPECT_EQ(marks[1].name, "left ear");
  EXPECT_EQ(marks[1].on_reference, Vec<3>(-0.1, 0, 0));
  EXPECT_EQ(marks[1].weight, 2);
}

TEST_F(LandmarkFile, TakesVerticesAndMixesThemWithPoints) {
  const auto marks = read("vertex1,x2,y2,z2\n2,7,8,9\n");
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].name, "line 2");
  EXPECT_EQ(marks[0].on_reference, corners[2]);
  EXPECT_EQ(marks[0].on_template, Vec<3>(7, 8, 9));
  EXPECT_EQ(read("vertex2,vertex1\n1,0\n")[0].on_template, others[1]);
}

TEST_F(LandmarkFile, TwoFilesBelongTogetherByName) {
  const auto marks = read("name,x,y,z\na,1,0,0\nb,2,0,0\n", "name,vertex\nb,1\na,0\n");
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[0].name, "a");
  EXPECT_EQ(marks[0].on_template, others[0]);
  EXPECT_EQ(marks[1].on_template, others[1]);
  EXPECT_EQ(marks[1].reference_origin, (folder / "a.csv") + ", line 3");
  EXPECT_EQ(marks[1].template_origin, (folder / "b.csv") + ", line 2");
}

TEST_F(LandmarkFile, StandardDeviationsWeighByTheirInverseSquares) {
  const auto marks = read("vertex1,vertex2,sd\n0,0,1\n1,1,2\n");
  EXPECT_DOUBLE_EQ(marks[0].weight, 1.6);
  EXPECT_DOUBLE_EQ(marks[1].weight, 0.4);
}

TEST_F(LandmarkFile, NoneWithoutAFile) {
  EXPECT_TRUE(read_landmarks<3>({}, corners, others).empty());
  options.template_file = "b.csv";
  EXPECT_NE(message_of<InputError>([&] { read_landmarks<3>(options, corners, others); }).find("landmarks.file"),
            std::string::npos);
}

TEST_F(LandmarkFile, NamesThatOneFileLacksMayBeLeftOut) {
  options.unpaired = UnpairedLandmarks::are_left_out;
  const auto marks = read("name,x,y,z\na,1,0,0\nb,2,0,0\n", "name,vertex\nc,1\nb,0\n");
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].name, "b");
  EXPECT_EQ(marks[0].on_template, others[0]);
  expect_refused("b.csv", "has no name in common with", "name,x,y,z\na,1,0,0\n", "name,x,y,z\nb,1,0,0\n");
}

TEST_F(LandmarkFile, SaysWhatIsWrongAndWhere) {
  const std::string head = "name,x1,y1,z1,x2,y2,z2\n";
  expect_refused("a.csv, line 1", "there is no column 'z2'; too few columns", "name,x1,y1,z1,x2,y2\na,1,2,3,4,5\n");
  expect_refused("a.csv, line 1", "unknown column 'x'", "name,x,y,z\na,1,2,3\n");
  expect_refused("a.csv, line 1", "two columns are named 'x1'", "x1,x1,y1,z1,x2,y2,z2\n");
  expect_refused("a.csv, line 1", "'weight' and 'sd' exclude each other", "vertex1,vertex2,sd,weight\n0,0,1,1\n");
  expect_refused("a.csv, line 1", "'vertex1' and 'x1' exclude each other", "vertex1,x1,y1,z1,vertex2\n0,1,2,3,0\n");
  expect_refused("a.csv, line 3", "6 values where the head line has 7 columns", head + "a,1,2,3,4,5,6\nb,1,2,3,4,5\n");
  expect_refused("a.csv, line 2", "y2 is 'five'; expected a number", head + "a,1,2,3,4,five,6\n");
  expect_refused("a.csv, line 2", "x1 is 'nan'; expected a number", head + "a,nan,2,3,4,5,6\n");
  expect_refused("a.csv, line 3", "the name 'a' stands in line 2 already", head + "a,1,2,3,4,5,6\na,1,2,3,4,5,6\n");
  expect_refused("a.csv, line 2", "vertex1 is 3; that shape has 3 vertices", "vertex1,vertex2\n3,0\n");
  expect_refused("a.csv, line 2", "vertex2 is '0.5'", "vertex1,vertex2\n0,0.5\n");
  expect_refused("a.csv, line 2", "sd is 0; expected a number > 0", "vertex1,vertex2,sd\n0,0,0\n");
  expect_refused("a.csv", "holds no landmark besides its head line", head);
  // Their squares would not be finite, or 0.
  expect_refused("a.csv, line 3", "sd is 1e-200; expected a number from 1e-50 to 1e+50",
                 "vertex1,vertex2,sd\n0,0,1\n1,1,1e-200\n");
  expect_refused("a.csv, line 2", "weight is 1e+300; expected a number from", "vertex1,vertex2,weight\n0,0,1e300\n");
  expect_refused("b.csv, line 3", "the name 'c' is unknown to", "name,x,y,z\na,1,0,0\n",
                 "name,x,y,z\na,1,0,0\nc,1,0,0\n");
  expect_refused("a.csv, line 3", "the name 'b' is unknown to", "name,x,y,z\na,1,0,0\nb,1,0,0\n",
                 "name,x,y,z\na,1,0,0\n");
  expect_refused("b.csv, line 1", "no column 'name'", "name,x,y,z\na,1,0,0\n", "x,y,z\n1,0,0\n");
}

}  // namespace
}  // namespace shellmatch
