// Control points of 3D Slicer: what the files say, what goes out again, and what is wrong with them in one line.

#include "base/stop.h"
#include "matching/pairs/landmark_file.h"
#include "matching/pairs/slicer_points.h"
#include "tests/matching/output/temporary_folder.h"
#include "tests/support/expect_input_error.h"
#include "tests/support/slowdown.h"

#include <gtest/gtest.h>

#include <ctime>

namespace shellmatch {
namespace {

using testing::put;
using testing::TemporaryFolder;

// As Slicer 5 writes it, with a label in quotes; \r\n as on Windows.
const std::string fcsv =
    "# Markups fiducial file version = 5.0\r\n# CoordinateSystem = LPS\r\n"
    "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\r\n"
    "1,1.5,-2,3,0,0,0,1,1,1,0,\"nose, tip\",\"says \"\"here\"\"\",,2,0\r\n"
    "2,1e1,20,-30,0,0,0,1,1,0,0,F-2,,,2,0\r\n";

std::string json_with(const std::string& system, const std::string& more = "") {
  return "{\"@schema\": \"markups-schema-v1.0.3.json#\", \"markups\": [{\"type\": \"Fiducial\"" + system +
         ", \"controlPoints\": [{\"id\": \"1\", \"label\": \"nose\", \"description\": \"t\\u00fcp\", \"position\": "
         "[1.5, -2, 3], "
         "\"orientation\": [-1.0, -0.0, 0.0], \"selected\": true, \"positionStatus\": \"defined\"}" +
         more + "], \"display\": {\"color\": [0.4, 1.0, 0.0]}}]}";
}

struct SlicerFiles : ::testing::Test {
  TemporaryFolder folder;
  SlicerPoints read(const std::string& name, const std::string& text) {
    put(folder / name, text);
    return read_slicer_points(folder / name);
  }
  std::string options_file() { return folder / "nul.fcsv"; }
};

TEST_F(SlicerFiles, NamesOfFilesSayTheFormat) {
  for (const char* name : {"a.fcsv", "A.FCSV", "b.mrk.json", "b.MRK.json"}) EXPECT_TRUE(is_slicer_file(name)) << name;
  for (const char* name : {"a.csv", "b.json", ".fcsv", "fcsv", "a.fcsv.txt"})
    EXPECT_FALSE(is_slicer_file(name)) << name;
}

TEST_F(SlicerFiles, FcsvHasNamesAndItsFrame) {
  const SlicerPoints file = read("a.fcsv", fcsv);
  ASSERT_EQ(file.points.size(), 2u);
  EXPECT_EQ(file.points[0].name, "nose, tip");
  EXPECT_EQ(file.points[0].position, Vec<3>(1.5, -2, 3));
  EXPECT_EQ(file.points[0].space, Space::lps);
  EXPECT_EQ(file.points[1].position, Vec<3>(10, 20, -30));
  EXPECT_EQ(file.points[1].place, (folder / "a.fcsv") + ", line 5");
  EXPECT_EQ(read("b.fcsv", "# CoordinateSystem = 0\nid,1,2,3,0,0,0,1,1,1,0,a,,\n").points[0].space, Space::ras);
  EXPECT_EQ(read("b.fcsv", "# CoordinateSystem = 1\nid,1,2,3,0,0,0,1,1,1,0,a,,\n").points[0].space, Space::lps);
  EXPECT_EQ(read("b.fcsv", "id,1,2,3,0,0,0,1,1,1,0,a,,\n").points[0].space, Space::ras);
  // Columns stand where the file says.
  const SlicerPoint turned = read("b.fcsv", "# columns = label,z,y,x\na,3,2,1\n").points[0];
  EXPECT_EQ(turned.position, Vec<3>(1, 2, 3));
  EXPECT_EQ(turned.name, "a");
}

// Since 4.11 Slicer writes LPS; a file that names no version is one of Slicer 3.
TEST_F(SlicerFiles, FcsvWithoutFrameHasThatOfItsVersion) {
  const std::string point = "id,1,2,3,0,0,0,1,1,1,0,a,,\n";
  for (const auto& [version, space] : {std::pair{"4.10", Space::ras},
                                       {"4.6.2", Space::ras},
                                       {"4.11", Space::lps},
                                       {"4.13.0-2021", Space::lps},
                                       {"5.4", Space::lps},
                                       {"new", Space::ras}}) {
    const std::string head = std::string("# Markups fiducial file version = ") + version + "\n";
    EXPECT_EQ(read("b.fcsv", head + point).points[0].space, space) << version;
    EXPECT_EQ(read("b.fcsv", "# CoordinateSystem = RAS\n" + head + point).points[0].space, Space::ras) << version;
  }
}

TEST_F(SlicerFiles, FcsvSaysWhichPointsHaveNoPosition) {
  const std::string
      head = "# CoordinateSystem = LPS\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n",
      text = head +
             "1,nan,,3,0,0,0,1,1,1,0,a,,,0,0\n2,4,5,6,0,0,0,1,1,1,0,b,,,1,0\n3,7,8,9,0,0,0,1,1,1,0,c,,,2,0\n4,1,2,3,0,"
             "0,0,1,1,1,0,d,,,3,0\n"
             "5,1,2,3,0,0,0,1,1,1,0,e,,\n";
  const SlicerPoints file = read("b.fcsv", text);
  ASSERT_EQ(file.points.size(), 5u);
  for (const std::size_t i : {0u, 1u, 3u}) EXPECT_FALSE(file.points[i].has_position) << i;
  for (const std::size_t i : {2u, 4u}) EXPECT_TRUE(file.points[i].has_position) << i;
  // Their lines stay as they are.
  std::string expected = text;
  expected.replace(expected.find("7,8,9"), 5, "9,9,9");
  expected.replace(expected.find("5,1,2,3"), 7, "5,9,9,9");
  EXPECT_EQ(with_positions(file, std::vector<Vec<3>>(5, Vec<3>(9, 9, 9))), expected);
  // Columns of another list are no status.
  EXPECT_TRUE(read("b.fcsv", "# columns = label,x,y,z\na,1,2,3,0,0,0,0,0,0,0,0,0,0,0\n").points[0].has_position);
  EXPECT_FALSE(read("b.fcsv", "# columns = label,x,y,z,positionStatus\na,1,2,3,3\n").points[0].has_position);
}

TEST_F(SlicerFiles, InspectionNamesTheFrame) {
  const SlicerPoints file = read("a.fcsv", fcsv + "3,1,2,3,0,0,0,1,1,1,0,gone,,,3,0\r\n");
  EXPECT_NE(slicer_points_text(file).find("3 points, of which 1 without position"), std::string::npos);
  EXPECT_NE(slicer_points_text(file).find("frame                 LPS"), std::string::npos) << slicer_points_text(file);
  EXPECT_NE(slicer_points_json(file).find("\"frame\": \"LPS\""), std::string::npos);
  EXPECT_NE(slicer_points_json(file).find("\"position\": null"), std::string::npos);
}

// Reading a hundred times as many points takes a hundred times as long, not ten thousand times, and hears signals.
TEST_F(SlicerFiles, MarkupsOfManyPointsAreReadInLinearTime) {
  const auto many = [](int n) {
    std::string list;
    for (int i = 0; i < n; ++i)
      list +=
          fmt::format("{}{{\"label\": \"{}\", \"position\": [1, 2, 3], \"orientation\": [1, 0, 0]}}", i ? "," : "", i);
    return "{\"markups\": [{\"controlPoints\": [" + list + "]}]}";
  };
  put(folder / "many.mrk.json", many(200000));
  const std::clock_t begin = std::clock();
  EXPECT_EQ(read_slicer_points(folder / "many.mrk.json").points.size(), 200000u);
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 30 * test::slowdown);
  stop_loops_when([] { return StopCause::request; });
  EXPECT_THROW(read_slicer_points(folder / "many.mrk.json"), Stopped);
  stop_loops_when(nullptr);
}

TEST_F(SlicerFiles, ANulDoesNotCutAMessage) {
  using namespace std::string_literals;
  put(options_file(), "# columns = label,x,y,z\na\0b,1,2,3\na\0b,1,2,3\n"s);
  LandmarkOptions options;
  options.file = options.template_file = options_file();
  expect_input_error([&] { read_landmarks<3>(options, {}, {}); }, {"the name 'a\\x00b' stands in", "line 2 already"});
}

TEST_F(SlicerFiles, FcsvGoesOutAsItCameButForPositions) {
  const SlicerPoints file = read("a.fcsv", fcsv);
  std::string expected = fcsv;
  expected.replace(expected.find("1.5,-2,3"), 8, "0.1,7,-8.25");
  expected.replace(expected.find("1e1,20,-30"), 10, "1,2,3");
  EXPECT_EQ(with_positions(file, {Vec<3>(0.1, 7, -8.25), Vec<3>(1, 2, 3)}), expected);
}

TEST_F(SlicerFiles, MarkupsHaveTheirFrame) {
  for (const char* system :
       {", \"coordinateSystem\": \"LPS\"", ", \"coordinateSystem\": 1", ", \"coordinateSystem\": \"1\"", ""})
    EXPECT_EQ(read("a.mrk.json", json_with(system)).points.at(0).space, Space::lps) << system;
  for (const char* system : {", \"coordinateSystem\": \"RAS\"", ", \"coordinateSystem\": 0"})
    EXPECT_EQ(read("a.mrk.json", json_with(system)).points.at(0).space, Space::ras) << system;
}

TEST_F(SlicerFiles, MarkupsGoOutAsTheyCameButForPositions) {
  const std::string text =
      json_with(", \"coordinateSystem\": \"RAS\"",
                ", {\"label\": \"next\", \"position\": [9, 9, 9], \"positionStatus\": \"undefined\"}");
  const SlicerPoints file = read("a.mrk.json", text);
  ASSERT_EQ(file.points.size(), 2u);
  EXPECT_EQ(file.points[0].position, Vec<3>(1.5, -2, 3));
  EXPECT_TRUE(file.points[0].has_position);
  EXPECT_FALSE(file.points[1].has_position);
  std::string out = with_positions(file, {Vec<3>(0.1, 7, -8.25), Vec<3>(1, 1, 1)});
  std::erase_if(out, [](char c) { return c == ' ' || c == '\n'; });
  std::string expected = text;
  expected.replace(expected.find("[1.5, -2, 3]"), 12, "[0.1,7.0,-8.25]");
  std::erase_if(expected, [](char c) { return c == ' ' || c == '\n'; });
  expected.replace(expected.find("\\u00fc"), 6, "\xc3\xbc");
  EXPECT_EQ(out, expected);
}

TEST_F(SlicerFiles, DamageIsSaidInOneLine) {
  const auto refused = [&](const std::string& name, const std::string& text, std::initializer_list<std::string> parts) {
    SCOPED_TRACE(text.substr(0, 100));
    expect_input_error([&] { read(name, text); }, parts);
  };
  refused("a.fcsv", "# CoordinateSystem = IJK\n", {"a.fcsv, line 1", "'IJK'; expected RAS or LPS"});
  refused("a.fcsv", "# columns = id,x,y,label\n", {"line 1", "no 'z'"});
  refused("a.fcsv", "1,2,3,4,0,0,0,1,1,1,0,F-2,,,7,0\n", {"line 1", "status of the position is '7'"});
  refused("a.fcsv", "1,2,3,4\n", {"line 1", "4 values where the columns want 12"});
  refused("a.fcsv", "# columns = label,x,y,z\na,1,2,nan\n", {"line 2", "z is 'nan'; expected a number"});
  refused("a.fcsv", "# nothing\n", {"holds no control points"});
  refused("a.mrk.json", "{\"markups\": [", {"a.mrk.json", "no markups of 3D Slicer"});
  refused("a.mrk.json", "[]", {"there is no list 'markups'"});
  refused("a.mrk.json", "{\"markups\": [1]}", {"an entry of 'markups' is no object"});
  refused("a.mrk.json", "{\"markups\": [{\"controlPoints\": 1}]}", {"'controlPoints' is no list"});
  refused("a.mrk.json", "{\"markups\": [{\"controlPoints\": [{\"position\": [1, 2]}]}]}",
          {"control point 1", "three numbers"});
  refused("a.mrk.json", "{\"markups\": [{\"controlPoints\": [{\"position\": [1, 2, \"3\"]}]}]}",
          {"control point 1", "three numbers"});
  refused("a.mrk.json", "{\"markups\": [{\"coordinateSystem\": \"IJK\"}]}", {"coordinate system is \"IJK\""});
  refused("a.mrk.json", "{\"markups\": []}", {"holds no control points"});
  refused("a.mrk.json", "{\"markups\": " + std::string(100000, '['), {"nested too deeply"});
}

struct SlicerLandmarks : SlicerFiles {
  const std::vector<Vec<3>> vertices = {{0, 0, 0}, {1, 2, 3}};
  LandmarkOptions options;
  std::vector<std::string> notes;
  std::vector<Landmark<3>> landmarks(const std::string& a, const std::string& name_a, const std::string& b,
                                     const std::string& name_b, const LandmarkSpaces& spaces = {}) {
    put(options.file = folder / name_a, a);
    put(options.template_file = folder / name_b, b);
    notes.clear();
    return read_landmarks<3>(options, vertices, vertices, spaces, &notes);
  }
};

TEST_F(SlicerLandmarks, AreConvertedToTheFrameOfTheShapes) {
  const std::string table = "label,z,y,x\nnose,3,2,1\n", lps = json_with(", \"coordinateSystem\": \"LPS\"");
  // Shapes that name no frame are RAS.
  auto marks = landmarks(lps, "a.mrk.json", table, "b.csv");
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].name, "nose");
  EXPECT_EQ(marks[0].on_reference, Vec<3>(-1.5, 2, 3));
  EXPECT_EQ(marks[0].on_template, Vec<3>(1, 2, 3));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("1 point from LPS to RAS"), std::string::npos) << notes[0];
  // In the frame of the shapes nothing is to be done.
  marks = landmarks(lps, "a.mrk.json", table, "b.csv", {Space::lps, Space::lps});
  EXPECT_EQ(marks[0].on_reference, Vec<3>(1.5, -2, 3));
  EXPECT_TRUE(notes.empty());
  // A table is in the frame of its shape's file; numbers of vertices are those of shapes that are converted already.
  marks = landmarks(table, "b.csv", lps, "a.mrk.json", {Space::ras, Space::lps});
  EXPECT_EQ(marks[0].on_reference, Vec<3>(-1, -2, 3));
  EXPECT_EQ(marks[0].on_template, Vec<3>(1.5, -2, 3));
  marks = landmarks("name,vertex\nnose,1\n", "b.csv", lps, "a.mrk.json", {Space::ras, Space::lps});
  EXPECT_EQ(marks[0].on_reference, Vec<3>(1, 2, 3));
}

TEST_F(SlicerLandmarks, NeedNamesAndTwoFiles) {
  const std::string table = "name,x,y,z\na,3,2,1\n", head = "# columns = label,x,y,z\n";
  expect_input_error([&] { landmarks(head + "a,1,2,3\na,4,5,6\n", "a.fcsv", table, "b.csv"); },
                     {"a.fcsv, line 3", "stands in", "line 2 already"});
  expect_input_error([&] { landmarks(head + ",1,2,3\n", "a.fcsv", table, "b.csv"); },
                     {"a.fcsv, line 2", "the label is empty"});
  expect_input_error([&] { landmarks(head + "b,1,2,3\n", "a.fcsv", table, "b.csv"); },
                     {"b.csv, line 2", "the name 'a' is unknown to"});
  put(options.file = folder / "a.fcsv", head + "a,1,2,3\n");
  options.template_file.clear();
  expect_input_error([&] { read_landmarks<3>(options, vertices, vertices); },
                     {"a.fcsv", "points of one shape", "--template-landmarks"});
  options.template_file = options.file;
  expect_input_error([&] { read_landmarks<2>(options, {}, {}); }, {"a.fcsv", "points of space"});
}

}  // namespace
}  // namespace shellmatch
