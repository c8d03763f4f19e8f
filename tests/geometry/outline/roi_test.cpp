// Regions of interest of ImageJ, as its encoder writes them: each kind at its place, y upward, and what bounds no area.
#include "tests/geometry/io/surface_files.h"
#include "tests/geometry/outline/outline_files.h"

#include <numbers>

namespace shellmatch::testing {
namespace {

using std::numbers::pi;
const std::vector<std::pair<double, double>> l_points = {{10, 20}, {40, 20}, {40, 60}, {30, 60}, {30, 30}, {10, 30}};

Roi polygon(int type = 0) {
  return {.type = type, .top = 20, .left = 10, .bottom = 60, .right = 40, .points = l_points};
}

class RoiFile : public ::testing::Test {
 protected:
  Shape<2> read(const std::string& bytes) const { return read_outline(folder_.write("cell.roi", bytes)); }
  std::string error(const std::string& bytes) const {
    return input_error_of([&] { read(bytes); });
  }
  TempFolder folder_;
};

TEST_F(RoiFile, PolygonsFreehandAndTracedOnesHaveTheirVerticesWithYUpward) {
  for (const int type : {0, 7, 8}) {
    const Shape<2> shape = read(polygon(type).bytes());
    EXPECT_EQ(ring(shape), (Points{{10, -20}, {40, -20}, {40, -60}, {30, -60}, {30, -30}, {10, -30}}));
    EXPECT_DOUBLE_EQ(area(shape.surface), 600);
    EXPECT_TRUE(has_note(shape, "y points down in the file and up in the result: y = -y"));
    EXPECT_EQ(shape.original.frame(Vec<2>(3, 7)), Vec<2>(3, -7));
  }
}

TEST_F(RoiFile, CoordinatesBetweenPixelsAreReadWhereTheVersionHasThem) {
  Roi roi = polygon();
  for (auto& [x, y] : roi.points) {
    x += 0.25;
    y += 0.5;
  }
  roi.options = 128;
  EXPECT_EQ(ring(read(roi.bytes()))[2], Vec<2>(40.25, -60.5));
  roi.version = 221;
  EXPECT_EQ(ring(read(roi.bytes()))[2], Vec<2>(40, -60));
}

TEST_F(RoiFile, RectanglesAndOvalsHaveTheirArea) {
  Roi box{.type = 1, .top = 5, .left = 2, .bottom = 11, .right = 10};
  EXPECT_EQ(ring(read(box.bytes())), (Points{{2, -5}, {10, -5}, {10, -11}, {2, -11}}));
  box.arc = 4;
  EXPECT_NEAR(area(read(box.bytes()).surface), 48 - (4 - pi) * 4, 1e-2);
  box.type = 2;
  box.arc = 0;
  const Shape<2> oval = read(box.bytes());
  EXPECT_NEAR(area(oval.surface), pi * 4 * 3, 2e-3 * pi * 12);
  EXPECT_TRUE(has_note(oval, "curves flattened to 0.0001 diagonals"));
  for (const Vec<2>& x : ring(oval)) EXPECT_NEAR(std::hypot((x.x() - 6) / 4, (x.y() + 8) / 3), 1, 1e-5);
  box.options = 128, box.floats = {2.5f, 5, 8, 6};
  EXPECT_NEAR(bounding_box(ring(read(box.bytes()))).max.x(), 10.5, 1e-12);
}

TEST_F(RoiFile, EllipsesAndRectanglesThatAreTurned) {
  Roi roi = polygon(7);
  roi.subtype = 3, roi.floats = {0, 0, 6, 8}, roi.parameter = 0.5f;
  const Shape<2> ellipse = read(roi.bytes());
  EXPECT_NEAR(area(ellipse.surface), pi * 5 * 2.5, 0.1);
  EXPECT_NEAR((ring(ellipse)[0] - Vec<2>(6, -8)).norm(), 0, 1e-6);
  roi.subtype = 5;
  roi.parameter = 2;
  const Shape<2> box = read(roi.bytes());
  EXPECT_NEAR(area(box.surface), 20, 1e-5);
  EXPECT_NEAR((ring(box)[0] - Vec<2>(0 - 0.8, -0.6)).norm(), 0, 1e-6);
}

TEST_F(RoiFile, CompositeOnesHaveHolesPartsAndCurves) {
  const Roi roi{.type = 1, .segments = {0, 0, 0, 1, 9,  0, 1, 9,  9,  1,  0, 9, 4, 0,  3, 3, 1,  6,  3,  1,  6,  6, 1,
                                        3, 6, 4, 0, 20, 0, 2, 25, 10, 30, 0, 4, 0, 40, 0, 3, 40, 10, 50, 10, 50, 0, 4}};
  const Shape<2> shape = read(roi.bytes());
  EXPECT_EQ(shape.original.polygons.size(), 4u);
  EXPECT_NEAR(area(shape.surface), 81 - 9 + 2.0 / 3 * 10 * 5 + 0.6 * 10 * 10, 0.1);
  EXPECT_TRUE(has_note(shape, "1 ring is a hole"));
}

TEST_F(RoiFile, SetsAreTakenTogetherOrByName) {
  Roi named = polygon(), other = polygon();
  named.name = u"Zelle \u00fc\U0001F52C";
  for (auto& [x, y] : other.points) x += 100;
  other.left += 100;
  const std::string path = folder_.write("RoiSet.zip", zip_bytes({{"0001.roi", named.bytes()},
                                                                  {"0002.roi", other.bytes()},
                                                                  {"line.roi", Roi{.type = 3}.bytes()},
                                                                  {"readme.txt", "a"}}));
  const Shape<2> all = read_outline(path);
  EXPECT_EQ(all.original.polygons.size(), 2u);
  EXPECT_TRUE(has_note(all, "2 areas taken together: 'Zelle \u00fc\U0001F52C', '0002'; FILE:NAME chooses"))
      << notes_of(all);
  EXPECT_TRUE(has_note(all, "1 region without an area left out"));
  EXPECT_TRUE(has_note(all, "1 other file in the archive"));
  for (const char* name : {":0001", ":Zelle \u00fc\U0001F52C"})
    EXPECT_EQ(ring(read_outline(path + name))[0], Vec<2>(10, -20)) << name;
  EXPECT_EQ(ring(read_outline(path + ":0002"))[0], Vec<2>(110, -20));
  EXPECT_TRUE(
      contains(input_error_of([&] { read_outline(path + ":3"); }), "no area is named '3'; choose one of 'Zelle"));
}

TEST_F(RoiFile, AreasThatCrossAreToBeChosen) {
  Roi shifted = polygon();
  for (auto& [x, y] : shifted.points) {
    x += 5;
    y += 5;
  }
  shifted.left += 5;
  shifted.top += 5;
  const std::string path =
      folder_.write("set.zip", zip_bytes({{"a.roi", polygon().bytes()}, {"b.roi", shifted.bytes()}}));
  const std::string text = input_error_of([&] { read_outline(path); });
  EXPECT_TRUE(contains(text, "crosses or touches itself"));
  EXPECT_TRUE(contains(text, "choose one, as in \"" + path + ":NAME\", of 'a', 'b'"));
}

TEST_F(RoiFile, AnArchiveWhosePartsLieOnEachOtherIsRefused) {
  const std::string one = zip_bytes({{"0000.roi", polygon().bytes() + std::string(200000, ' ')}});
  const std::size_t begin = one.rfind("PK\1\2"), end = one.rfind("PK\5\6");
  std::string bomb = one.substr(0, begin), tail = one.substr(end);
  constexpr int n = 2500;
  for (int k = 0; k < n; ++k) {
    std::string entry = one.substr(begin, end - begin);
    entry.replace(entry.size() - 8, 4, fmt::format("{:04}", k));
    bomb += entry;
  }
  tail.replace(
      8, 4,
      {static_cast<char>(n & 255), static_cast<char>(n >> 8), static_cast<char>(n & 255), static_cast<char>(n >> 8)});
  const std::string path = folder_.write("bomb.zip", bomb + tail);
  EXPECT_TRUE(contains(input_error_of([&] { read_outline(path); }), "its parts are larger than it can hold"));
}

TEST_F(RoiFile, SplinesAreSaid) {
  Roi roi = polygon();
  roi.options = 1;
  EXPECT_TRUE(has_note(read(roi.bytes()), "1 area fitted by a spline in ImageJ"));
}

TEST_F(RoiFile, WhatIsWrongIsSaidOnce) {
  EXPECT_TRUE(contains(error("Jout" + polygon().bytes().substr(4)), "does not begin with 'Iout'"));
  EXPECT_TRUE(contains(error(polygon().bytes().substr(0, 70)), "cut off or damaged"));
  EXPECT_TRUE(contains(error(polygon().bytes().substr(0, 40)), "cut off or damaged"));
  EXPECT_TRUE(contains(error(polygon(10).bytes()), "points instead of an area"));
  EXPECT_TRUE(contains(error(Roi{.type = 1, .subtype = 1, .bottom = 5, .right = 5}.bytes()), "a text instead of an"));
  EXPECT_TRUE(contains(error(Roi{.type = 1, .subtype = 4, .bottom = 5, .right = 5}.bytes()), "an image instead of an"));
  EXPECT_TRUE(contains(error(polygon(11).bytes()), "the type 11"));
  EXPECT_TRUE(contains(error(Roi{.type = 1, .right = 5}.bytes()), "a rectangle of 5 x 0 pixels has no area"));
  EXPECT_TRUE(contains(error(Roi{.points = {{0, 0}, {1, 1}}}.bytes()), "2 points has no area"));
  EXPECT_TRUE(contains(error(Roi{.type = 1, .segments = {0, 0, 0, 7}}.bytes()), "of the kind 7"));
  EXPECT_TRUE(contains(error(Roi{.type = 1, .segments = {0, 0, 0, 1, 2}}.bytes()), "cut off"));
  const std::string path = folder_.write("a.zip", zip_bytes({{"a.txt", "a"}}));
  EXPECT_TRUE(contains(input_error_of([&] { read_outline(path); }), "ROI Manager"));
  EXPECT_TRUE(contains(input_error_of([&] {
                         read_outline(folder_.write("b.zip", zip_bytes({{"a.roi", "a"}})));
                       }),
                       "its part 'a.roi': no region"));
}

}  // namespace
}  // namespace shellmatch::testing
