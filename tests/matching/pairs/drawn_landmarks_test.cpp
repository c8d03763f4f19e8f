// Landmarks of drawings: coordinates of CSV are those of the shape's file, and go where its outline goes; TPS files of
// landmarks.

#include "matching/input/shape_pair.h"
#include "matching/pairs/landmark_file.h"
#include "matching/pairs/point_formats.h"
#include "matching/pairs/tps_specimens.h"
#include "tests/matching/output/temporary_folder.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::put;
using testing::TemporaryFolder;

struct HeardNotes : Observer {
  std::vector<std::string> all;
  void note(const std::string& text) override { all.push_back(text); }
};

// An L whose foot points right: its points, y down the rows of a picture of 60 rows.
const std::vector<Vec<2>> letter_l = {{10, 10}, {20, 10}, {20, 40}, {45, 40}, {45, 50}, {10, 50}};

std::string table_of(const std::vector<Vec<2>>& points) {
  std::string text = "x,y\n";
  for (const Vec<2>& x : points) text += fmt::format("{},{}\n", x.x(), x.y());
  return text;
}
std::string landmark_csv(const std::vector<Vec<2>>& points) {
  std::string text = "name,x,y\n";
  for (std::size_t i = 0; i < points.size(); ++i)
    text += fmt::format("{},{},{}\n", i + 1, points[i].x(), points[i].y());
  return text;
}
std::string svg_of(double scale) {
  std::string text;
  for (const Vec<2>& x : letter_l) text += fmt::format("{},{} ", x.x(), x.y());
  return fmt::format("<svg width=\"{}mm\" viewBox=\"0 0 60 60\"><polygon id=\"L\" points=\"{}\"/></svg>", 60 * scale,
                     text);
}

struct DrawnLandmarks : ::testing::Test {
  TemporaryFolder folder;
  ExperimentOptions options;
  HeardNotes notes;

  std::vector<Landmark<2>> landmarks(const std::string& reference, const std::string& template_file,
                                     const std::string& of_reference, const std::string& of_template) {
    options.input.reference = folder / reference;
    options.input.template_file = folder / template_file;
    options.landmarks.file = of_reference.empty() ? "" : folder / of_reference;
    options.landmarks.template_file = of_template.empty() ? "" : folder / of_template;
    const auto pair = std::get<ShapePair<2>>(open_shape_pair(options.input, options.landmarks, notes));
    reference_ = pair.reference.original.vertices;
    return read_landmarks<2>(options.landmarks, pair.reference.original.vertices, pair.template_shape.original.vertices,
                             landmark_spaces(pair), &notes.all);
  }
  // The picture with the L in it, and a pixel of background around.
  void put_picture() {
    std::string text = "P2 60 60 255\n";
    for (int row = 0; row < 60; ++row)
      for (int column = 0; column < 60; ++column)
        text += (row >= 10 && row < 50 && column >= 10 && (column < 20 || (row >= 40 && column < 45))) ? "255 " : "0 ";
    put(folder / "mask.pgm", text);
  }
  bool has_note(const std::string& part) const {
    return std::ranges::any_of(notes.all, [&](const std::string& text) { return text.find(part) != text.npos; });
  }
  std::vector<Vec<2>> reference_;
};

TEST_F(DrawnLandmarks, FollowTheDrawing) {
  put(folder / "a.svg", svg_of(0.5));
  put(folder / "b.csv", table_of(letter_l));
  put(folder / "l.csv", landmark_csv(letter_l));
  const auto found = landmarks("a.svg", "b.csv", "l.csv", "l.csv");
  for (std::size_t i = 0; i < letter_l.size(); ++i) {
    EXPECT_EQ(found[i].on_reference, reference_[i]);
    EXPECT_EQ(found[i].on_reference, Vec<2>(0.5 * letter_l[i].x(), -0.5 * letter_l[i].y()));
    EXPECT_EQ(found[i].on_template, letter_l[i]) << "a table is as it stands";
  }
  put(folder / "both.csv", "x1,y1,x2,y2\n10,10,10,50\n");
  const auto both = landmarks("b.csv", "a.svg:L", "both.csv", "");
  EXPECT_EQ(both[0].on_reference, Vec<2>(10, 10));
  EXPECT_EQ(both[0].on_template, Vec<2>(5, -25));
}

TEST_F(DrawnLandmarks, FollowAnOutlineIntoTheFrameOfItsPicture) {
  put_picture();
  put(folder / "rows.csv", table_of(letter_l));
  put(folder / "drawn.svg", svg_of(1));
  put(folder / "l.csv", landmark_csv(letter_l));
  put(folder / "upward.csv", landmark_csv({{10, 50}, {20, 50}, {20, 20}, {45, 20}, {45, 10}, {10, 10}}));
  for (const std::string outline : {"rows.csv", "drawn.svg"}) {
    notes.all.clear();
    const auto found = landmarks(outline, "mask.pgm", "l.csv", "upward.csv");
    EXPECT_TRUE(has_note(outline + ": fits")) << outline;
    EXPECT_TRUE(has_note("used as y = 60 - y, the frame of pictures, with its landmarks"));
    for (std::size_t i = 0; i < letter_l.size(); ++i) {
      EXPECT_EQ(found[i].on_reference, Vec<2>(letter_l[i].x(), 60 - letter_l[i].y())) << outline;
      EXPECT_EQ(found[i].on_reference, reference_[i]);
      EXPECT_EQ(found[i].on_template, found[i].on_reference);
    }
    const auto other_way = landmarks("mask.pgm", outline, "upward.csv", "l.csv");
    EXPECT_EQ(other_way[3].on_template, Vec<2>(45, 20)) << outline;
  }
}

TEST_F(DrawnLandmarks, OfTpsFilesAreNamedByTheirNumbers) {
  put(folder / "b.csv", table_of(letter_l));
  put(folder / "a.tps", "LM=2\n10 10\n20 10\nID=left\nSCALE=1\nLM=2\n5 5\nNA NA\nID=right\nSCALE=2\n");
  put(folder / "l.csv", landmark_csv(letter_l));
  const auto found = landmarks("b.csv", "b.csv", "a.tps:left", "a.tps:right");
  ASSERT_EQ(found.size(), 1u) << "one of the two is missing in the other";
  EXPECT_EQ(found[0].on_reference, Vec<2>(10, 10));
  EXPECT_EQ(found[0].on_template, Vec<2>(10, 10));
  EXPECT_TRUE(has_note("a.tps:right: coordinates multiplied by SCALE=2"));
  EXPECT_TRUE(has_note("1 point without position left out"));
  EXPECT_EQ(landmarks("b.csv", "b.csv", "l.csv", "l.csv").size(), 6u);
  expect_input_error([&] { landmarks("b.csv", "b.csv", "a.tps", "l.csv"); },
                     {"a.tps: 2 specimens in it; choose one by its ID"});
  expect_input_error([&] { landmarks("b.csv", "b.csv", "a.tps:left", ""); }, {"holds points of one shape"});
  expect_input_error([&] { landmarks("b.csv", "b.csv", "a.tps:middle", "l.csv"); },
                     {"no specimen has the ID 'middle'"});
}

TEST_F(DrawnLandmarks, InspectionListsSpecimens) {
  const std::string file = folder / "a.tps";
  put(file,
      "LM=2\n10 10\nNA NA\nID=left\nLM=3\n5 5\n1 1\n10 20\nOUTLINES=1\nPOINTS=3\n0 0\n1 0\n0 "
      "1\nIMAGE=b.jpg\nSCALE=2\n");
  const auto all = listed_specimens(file), left = listed_specimens(file + ":left");
  ASSERT_TRUE(all && left);
  EXPECT_FALSE(listed_specimens(file + ":b")) << "is an outline";
  EXPECT_FALSE(listed_specimens("b.csv"));
  const std::string text = specimens_text(file, *all);
  for (const char* part :
       {"a.tps: 2 specimens of TPS\n", "landmarks             2 to 3 of the plane, of which 0 to 1 without position\n",
        "outlines and curves   0 to 1\n", "with SCALE=           1\n", "names                 'left', 'b.jpg'\n"})
    EXPECT_NE(text.find(part), text.npos) << part << text;
  EXPECT_NE(specimens_text(file, *left).find("1 specimen of TPS"), text.npos);
  const std::string json = specimens_json(file, *all);
  for (const char* part : {"\"name\": \"left\"", "null", "20.0", "\"curves\": 1"})
    EXPECT_NE(json.find(part), json.npos) << part << json;
}

TEST_F(DrawnLandmarks, WhatIsWrittenAsTpsIsReadBack) {
  const std::vector<PointSet<2>> sets = {{"a", {"1", "2"}, {Vec<2>(0.1, -7e-9), Vec<2>(1.0 / 3, 5)}},
                                         {"b", {"1", "2"}, {std::nullopt, Vec<2>(2, 3)}}};
  put(folder / "a.tps", point_sets_text<2>(PointFormat::tps, sets, Space::unsaid));
  std::vector<std::string> said;
  const auto a = read_named_points<2>(folder / "a.tps:a", {}, Space::unsaid, Space::unsaid, said),
             b = read_named_points<2>(folder / "a.tps:b", {}, Space::unsaid, Space::unsaid, said);
  EXPECT_EQ(a.at(0).point, sets[0].points[0]);
  EXPECT_EQ(a.at(1).point, sets[0].points[1]);
  ASSERT_EQ(b.size(), 1u);
  EXPECT_EQ(b[0].name, "2");
  const std::vector<PointSet<3>> skull = {{"a", {"1"}, {Vec<3>(1, 2, 3)}}};
  put(folder / "s.tps", point_sets_text<3>(PointFormat::tps, skull, Space::lps));
  EXPECT_EQ(read_named_points<3>(folder / "s.tps", {}, Space::ras, Space::ras, said).at(0).point, Vec<3>(-1, -2, 3))
      << "in the frame that the file names";
  expect_input_error([&] { read_named_points<2>(folder / "s.tps", {}, Space::unsaid, Space::unsaid, said); },
                     {"LM3= holds points of space"});
  put(folder / "none.tps", "LM=1\nNA NA\n");
  expect_input_error([&] { read_named_points<2>(folder / "none.tps", {}, Space::unsaid, Space::unsaid, said); },
                     {"none of its points has a position"});
  put(folder / "empty.tps", "LM=0\nID=a\n");
  expect_input_error([&] { read_named_points<2>(folder / "empty.tps", {}, Space::unsaid, Space::unsaid, said); },
                     {"LM= or LM3= is missing or 0"});
}

}  // namespace
}  // namespace shellmatch
