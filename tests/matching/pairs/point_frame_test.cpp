// The frame of meshes that name none, told by points of 3D Slicer; and points that a file lists without a position.

#include "geometry/io/write_shape.h"
#include "matching/input/shape_pair.h"
#include "matching/pairs/landmark_file.h"
#include "matching/pairs/point_frame.h"
#include "tests/geometry/surface/test_surfaces.h"
#include "tests/matching/output/temporary_folder.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::put;
using testing::TemporaryFolder;

struct Notes : Observer {
  std::vector<std::string> all;
  void note(const std::string& text) override { all.push_back(text); }
  bool has(const std::string& part) const {
    return std::ranges::any_of(all, [&](const std::string& text) { return text.find(part) != text.npos; });
  }
};

std::string fcsv_of(const std::vector<Vec<3>>& points, const char* system = "LPS",
                    const std::vector<int>& status = {}) {
  std::string text = fmt::format(
      "# Markups fiducial file version = 5.4\n# CoordinateSystem = {}\n"
      "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n",
      system);
  for (std::size_t i = 0; i < points.size(); ++i)
    text += fmt::format("{},{},{},{},0,0,0,1,1,1,0,L{},,,{},0\n", i, points[i].x(), points[i].y(), points[i].z(), i,
                        i < status.size() ? status[i] : 2);
  return text;
}

/// Two copies of a box that no half turn about z takes to itself, far from the axis or around it.
struct PointFrame : ::testing::Test {
  TemporaryFolder folder;
  std::vector<Vec<3>> corners;
  ExperimentOptions options;
  Notes notes;

  void shapes(const Vec<3>& at, Space reference = Space::unsaid, Space template_shape = Space::unsaid) {
    OriginalShape<3> shape;
    for (int c = 0; c < 8; ++c) shape.vertices.push_back(at + Vec<3>(c & 1 ? 5 : -1, c & 2 ? 2 : -1, c & 4 ? 1 : -1));
    shape.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    corners = shape.vertices;
    shape.space = reference;
    write_ply(options.input.reference = folder / "a.ply", shape);
    shape.space = template_shape;
    write_ply(options.input.template_file = folder / "b.ply", shape);
  }
  ShapePair<3> open(const std::string& a, const std::string& b) {
    put(options.landmarks.file = folder / "a.fcsv", a);
    put(options.landmarks.template_file = folder / "b.fcsv", b);
    notes.all.clear();
    return std::get<ShapePair<3>>(open_shape_pair(options.input, options.landmarks, notes));
  }
  std::vector<Landmark<3>> landmarks(const ShapePair<3>& pair) {
    return read_landmarks<3>(options.landmarks, pair.reference.original.vertices, pair.template_shape.original.vertices,
                             landmark_spaces(pair), &notes.all);
  }
};

TEST_F(PointFrame, IsThatInWhichThePointsLieOnTheShapes) {
  for (const Vec<3>& at : {Vec<3>(0, 0, 0), Vec<3>(40, -60, 8)}) {
    shapes(at);
    for (const auto& [system, space] : {std::pair{"LPS", Space::lps}, {"RAS", Space::ras}}) {
      const ShapePair<3> pair = open(fcsv_of(corners, system), fcsv_of(corners, system));
      EXPECT_EQ(pair.reference.original.space, space);
      EXPECT_EQ(pair.template_shape.original.space, space);
      EXPECT_TRUE(notes.has(std::string("b.ply: names no frame; taken to be ") + system + ", in which the points of"));
      for (const Landmark<3>& l : landmarks(pair)) EXPECT_EQ(l.on_reference, l.on_template);
      EXPECT_EQ(landmarks(pair)[3].on_reference, corners[3]);
    }
    // The points of one shape tell the frame of both.
    std::vector<Vec<3>> turned = corners;
    change_space(turned, Space::lps, Space::ras);
    const ShapePair<3> pair = open(fcsv_of(turned, "LPS"), "# columns = label,x,y,z\nL0,1,1,1\n");
    EXPECT_EQ(pair.template_shape.original.space, Space::ras);
  }
}

TEST_F(PointFrame, OfTwoMeshesMayDiffer) {
  shapes({40, -60, 8});
  std::vector<Vec<3>> turned = corners;
  change_space(turned, Space::lps, Space::ras);
  const ShapePair<3> pair = open(fcsv_of(corners), fcsv_of(turned));
  EXPECT_TRUE(notes.has("from LPS to RAS, the frame of"));
  EXPECT_EQ(landmarks(pair)[2].on_template, corners[2]);
  EXPECT_EQ(landmarks(pair)[2].on_reference, turned[2]);
}

TEST_F(PointFrame, IsSlicersWherePointsDoNotTellIt) {
  shapes({0, 0, 0});
  for (const std::vector<Vec<3>>& points : {std::vector<Vec<3>>{{0, 0, 1}, {0.5, 0.5, -1}}, {{900, 0, 0}}}) {
    const ShapePair<3> pair = open(fcsv_of(points), fcsv_of(points));
    EXPECT_EQ(pair.reference.original.space, Space::lps);
    EXPECT_TRUE(notes.has("taken to be LPS, as 3D Slicer does"));
    EXPECT_EQ(landmarks(pair)[0].on_reference, points[0]);
  }
  // CSV is in the frame of its shape.
  options.landmarks = {};
  EXPECT_EQ(std::get<ShapePair<3>>(open_shape_pair(options.input, options.landmarks, notes)).reference.original.space,
            Space::unsaid);
}

TEST_F(PointFrame, IsWhatTheUserOrTheMeshSays) {
  shapes({0, 0, 0});
  options.input.space = SpaceKind::ras;
  const ShapePair<3> pair = open(fcsv_of(corners), fcsv_of(corners));
  EXPECT_EQ(pair.reference.original.space, Space::ras);
  EXPECT_TRUE(notes.has("RAS by input.space"));
  EXPECT_EQ(landmarks(pair)[1].on_reference, Vec<3>(-corners[1].x(), -corners[1].y(), corners[1].z()));
  options.input.space = SpaceKind::automatic;
  shapes({0, 0, 0}, Space::ras, Space::ras);
  EXPECT_EQ(open(fcsv_of(corners), fcsv_of(corners)).reference.original.space, Space::ras);
}

TEST_F(PointFrame, BesideAShapeOfACohort) {
  shapes({40, -60, 8});
  put(folder / "p.fcsv", fcsv_of(corners, "RAS"));
  OriginalShape<3> shape{.vertices = corners, .polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}}, .attributes = {}};
  EXPECT_EQ(space_beside(shape, folder / "p.fcsv", Space::unsaid), Space::ras);
  EXPECT_EQ(space_beside(shape, folder / "p.fcsv", Space::lps), Space::lps);
  EXPECT_EQ(space_beside(shape, folder / "p.csv", Space::unsaid), Space::unsaid);
  shape.polygons.clear();
  EXPECT_EQ(space_beside(shape, folder / "p.fcsv", Space::unsaid), Space::lps);
  shape.space = Space::ras;
  EXPECT_EQ(space_beside(shape, folder / "p.fcsv", Space::unsaid), Space::ras);
}

std::string markups_of(const std::vector<Vec<3>>& points, const std::vector<const char*>& status = {}) {
  std::string list;
  for (std::size_t i = 0; i < points.size(); ++i)
    list +=
        fmt::format("{}{{\"label\": \"L{}\", \"position\": [{}, {}, {}], \"positionStatus\": \"{}\"}}", i ? ", " : "",
                    i, points[i].x(), points[i].y(), points[i].z(), i < status.size() ? status[i] : "defined");
  return "{\"markups\": [{\"type\": \"Fiducial\", \"coordinateSystem\": \"LPS\", \"controlPoints\": [" + list + "]}]}";
}

TEST_F(PointFrame, PointsWithoutPositionAreLeftOutOfBothFiles) {
  shapes({0, 0, 0}, Space::lps, Space::lps);
  const std::string csv = "name,x,y,z\nL0,,,\nL1,NA,NA,NA\nL2,nan,NaN,nan\nL3,5,2,-1\n";
  const std::vector<std::pair<std::string, std::string>> with_gaps = {
      {"g.fcsv", fcsv_of({corners.begin(), corners.begin() + 4}, "LPS", {0, 1, 3, 2})},
      {"g.mrk.json", markups_of({corners.begin(), corners.begin() + 4}, {"undefined", "preview", "missing"})},
      {"g.csv", csv}};
  put(folder / "whole.mrk.json", markups_of({corners.begin(), corners.begin() + 4}));
  for (const auto& [name, text] : with_gaps) {
    SCOPED_TRACE(name);
    put(folder / name, text);
    for (const bool first : {true, false}) {
      options.landmarks.file = folder / (first ? name : "whole.mrk.json");
      options.landmarks.template_file = folder / (first ? "whole.mrk.json" : name);
      std::vector<std::string> said;
      const auto found = read_landmarks<3>(options.landmarks, corners, corners, {Space::lps, Space::lps}, &said);
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].name, "L3");
      EXPECT_EQ(found[0].on_reference, corners[3]);
      ASSERT_EQ(said.size(), 1u);
      EXPECT_NE(said[0].find("3 points without position left out"), std::string::npos) << said[0];
    }
  }
  // A name that the other file does not have at all may be misspelt.
  put(options.landmarks.file = folder / "more.csv", csv + "L9,5,2,-1\n");
  options.landmarks.template_file = folder / "whole.mrk.json";
  expect_input_error([&] { read_landmarks<3>(options.landmarks, corners, corners); },
                     {"more.csv, line 6", "'L9' is unknown"});
  put(options.landmarks.file = folder / "none.csv", "name,x,y,z\nL0,,,\n");
  expect_input_error([&] { read_landmarks<3>(options.landmarks, corners, corners); },
                     {"none.csv", "none of its points has a position"});
}

}  // namespace
}  // namespace shellmatch
