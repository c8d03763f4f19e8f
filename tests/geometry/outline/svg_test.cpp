// SVG: every command of path data, shapes, transformations, units, fill rules, names, and what is hidden.
#include "tests/geometry/outline/outline_files.h"

#include <numbers>

namespace shellmatch::testing {
namespace {

using std::numbers::pi;

class Svg : public ::testing::Test {
 protected:
  Shape<2> read(const std::string& body, const std::string& head = "", const std::string& part = "") const {
    return read_outline(
        folder_.write("leaf.svg", "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" " + head + ">" +
                                      body + "</svg>") +
        part);
  }
  Shape<2> path(const std::string& data, const std::string& more = "") const {
    return read("<path d=\"" + data + "\" " + more + "/>");
  }
  std::string error(const std::string& body, const std::string& head = "", const std::string& part = "") const {
    return input_error_of([&] { read(body, head, part); });
  }
  TempFolder folder_;
};

void expect_near(const Points& found, const Points& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR((found[i] - wanted[i]).norm(), 0, 1e-12) << i;
}

TEST_F(Svg, LinesOfAllKindsAreTheirVertices) {
  const Points wanted = {{1, -2}, {11, -2}, {11, -12}, {1, -12}};
  for (const char* data : {"M1 2L11 2 11 12 1 12Z", "m1,2 10,0 0,10-10,0z", "M 1 2 H 11 V 12 H 1 z", "m1 2h10v10h-10",
                           "M1 2h1e1v+10.0l-10-0z", "M.1e1 2 11 2 11 12 1 12 1 2"})
    expect_near(ring(path(data)), wanted);
  EXPECT_TRUE(has_note(path("M1 2h9v9"), "1 open path closed by a line"));
  EXPECT_FALSE(has_note(path("M1 2h9v9z"), "open path"));
}

TEST_F(Svg, CurvesAreFlattenedToTheToleranceThatIsSaid) {
  // Below a cubic with control heights 0, h, h, 0 over a width w lies 3/5 h w, below a quadratic of control height h
  // 1/3 h w.
  EXPECT_NEAR(area(path("M0 0C0 10 10 10 10 0z").surface), 60, 2e-2);
  EXPECT_NEAR(area(path("m5 5c0 10 10 10 10 0z").surface), 60, 2e-2);
  EXPECT_NEAR(area(path("M0 0Q5 10 10 0z").surface), 100.0 / 3, 2e-2);
  EXPECT_NEAR(area(path("m1 1q5 10 10 0z").surface), 100.0 / 3, 2e-2);
  // Smooth ones go on in the direction of the last.
  expect_near(ring(path("M0 0C0 5 5 5 5 0S10-5 10 0V20H0z")), ring(path("M0 0C0 5 5 5 5 0C5-5 10-5 10 0V20H0z")));
  expect_near(ring(path("M0 0c0 5 5 5 5 0s5-5 5 0V20H0z")), ring(path("M0 0C0 5 5 5 5 0C5-5 10-5 10 0V20H0z")));
  expect_near(ring(path("M0 0Q2 5 5 0T10 0V20H0z")), ring(path("M0 0Q2 5 5 0Q8-5 10 0V20H0z")));
  expect_near(ring(path("M0 0H5S10-5 10 0V20H0z")), ring(path("M0 0H5C5 0 10-5 10 0V20H0z")));
  expect_near(ring(path("M0 0H5t5-5V20H0z")), ring(path("M0 0H5Q5 0 10-5V20H0z")));
  EXPECT_TRUE(has_note(path("M0 0C0 10 10 10 10 0z"), "curves flattened to 0.0001 diagonals"));
}

TEST_F(Svg, ArcsAreThoseOfTheFourThatTheFlagsSay) {
  const double small = 25 * (pi / 2 - 1) / 2, large = 25 * pi - small;
  // The chord of a quarter of a circle of radius 5.
  EXPECT_NEAR(area(path("M5 0A5 5 0 0 1 10 5z").surface), small, 5e-3);
  EXPECT_NEAR(area(path("M5 0A5 5 0 0 0 10 5z").surface), small, 5e-3);
  EXPECT_NEAR(area(path("M5 0A5 5 0 1 1 10 5z").surface), large, 2e-2);
  EXPECT_NEAR(area(path("M5 0a5 5 0 105 5z").surface), large, 2e-2);
  const auto lowest = [](const Shape<2>& shape) { return bounding_box(ring(shape)).min.y(); };
  EXPECT_NEAR(lowest(path("M0 0A5 5 0 0 1 10 0z")), 0, 1e-12);
  EXPECT_NEAR(lowest(path("M0 0A5 5 0 0 0 10 0z")), -5, 1e-4);
  // Radii that do not reach are enlarged, none are a line; axes are turned.
  EXPECT_NEAR(area(path("M0 0A1 2 0 0 0 10 0z").surface), pi * 5 * 10 / 2, 2e-2);
  EXPECT_DOUBLE_EQ(area(path("M0 0A0 2 0 0 0 10 0V10z").surface), 50);
  EXPECT_NEAR(area(path("M0 0A6 3 90 0 0 6 0A6 3 90 0 0 0 0z").surface), pi * 18, 3e-2);
  EXPECT_NEAR(lowest(path("M0 0A6 3 90 0 0 6 0A6 3 90 0 0 0 0z")), -6, 1e-3);
}

TEST_F(Svg, ShapesAreTheirAreas) {
  const auto area_of = [&](const std::string& body) { return area(read(body, "viewBox='0 0 200 100'").surface); };
  EXPECT_DOUBLE_EQ(area_of("<rect x='1' y='2' width='30' height='4'/>"), 120);
  EXPECT_DOUBLE_EQ(area_of("<rect width='50%' height='10%'/>"), 1000);
  EXPECT_NEAR(area_of("<rect width='10' height='10' rx='2'/>"), 100 - (4 - pi) * 4, 1e-2);
  EXPECT_NEAR(area_of("<rect width='10' height='10' rx='2' ry='50'/>"), 100 - (4 - pi) * 10, 2e-2);
  EXPECT_NEAR(area_of("<circle cx='3' r='2'/>"), pi * 4, 5e-3);
  EXPECT_NEAR(area_of("<ellipse rx='2' ry='1'/>"), pi * 2, 5e-3);
  EXPECT_NEAR(area_of("<ellipse rx='auto' ry='1'/>"), pi, 5e-3);
  EXPECT_DOUBLE_EQ(area_of("<polygon points='0,0 4,0 4,3'/>"), 6);
  EXPECT_DOUBLE_EQ(area_of("<polyline points='0 0 4 0 4 3'/><circle r='0'/><rect width='5'/><polygon points=''/>"), 6);
  EXPECT_DOUBLE_EQ(area_of("<rect x='1mm' width='1in' height='1cm'/>"), 96 * 96 / 2.54);
  EXPECT_DOUBLE_EQ(area_of("<rect width='72pt' height='6pc' y='101.6Q'/>"), 96 * 96);
}

TEST_F(Svg, TransformationsAreAppliedFromTheInside) {
  const auto first = [&](const std::string& transform, const std::string& inner = "") {
    return ring(read("<g transform='" + transform + "'><path transform='" + inner + "' d='M1 2h3v3z'/></g>")).at(0);
  };
  const auto expect = [&](const Vec<2>& found, double x, double y) {
    EXPECT_NEAR((found - Vec<2>(x, -y)).norm(), 0, 1e-12) << found.transpose();
  };
  expect(first("translate(10)"), 11, 2);
  expect(first("translate(10, 20) scale(2)"), 12, 24);
  expect(first("scale(2 3)", "translate(10,20)"), 22, 66);
  expect(first("rotate(90)"), -2, 1);
  expect(first("rotate(90 1 1)"), 0, 1);
  expect(first("skewX(45)"), 3, 2);
  expect(first("skewY(45)"), 1, 3);
  expect(first(" matrix(1 2 3 4 5 6) ,"), 1 + 6 + 5, 2 + 8 + 6);
}

TEST_F(Svg, MillimetresWhereTheDrawingSaysThem) {
  const auto side = [&](const std::string& head) { return read("<rect width='10' height='10'/>", head); };
  const Shape<2> page = side("width='210mm' height='297mm' viewBox='0 0 420 594'");
  EXPECT_DOUBLE_EQ(area(page.surface), 25);
  EXPECT_EQ(page.unit, "mm");
  EXPECT_EQ(page.original.frame.scale, 0.5);
  EXPECT_EQ(page.original.frame.y_scale, -0.5);
  EXPECT_TRUE(has_note(page, "in millimetres: a unit of the drawing has 0.5"));
  EXPECT_NEAR(area(side("width='4in'").surface), 100 * (25.4 / 96) * (25.4 / 96), 1e-12);
  EXPECT_DOUBLE_EQ(area(side("width='100mm' height='100mm' viewBox='0 0 100 200'").surface), 25) << "it fits into both";
  EXPECT_DOUBLE_EQ(area(side("width='50mm' height='200mm' viewBox='0 0 100 100'").surface), 25);
  for (const char* head : {"", "width='300' height='200px'", "width='100%' viewBox='0 0 10 10'"}) {
    const Shape<2> plain = side(head);
    EXPECT_DOUBLE_EQ(area(plain.surface), 100) << head;
    EXPECT_EQ(plain.unit, "");
    EXPECT_TRUE(has_note(plain, "coordinates are units of the drawing"));
  }
  const Shape<2> nested = read(
      "<svg x='10' y='20' width='50' height='100' viewBox='100 0 100 100'><rect x='100' width='100%' "
      "height='100'/></svg>");
  EXPECT_EQ(ring(nested), (Points{{10, -45}, {60, -45}, {60, -95}, {10, -95}}));
}

TEST_F(Svg, FillRulesSayWhatIsAHole) {
  const std::string same = "M0 0h9v9h-9zM3 3h3v3h-3z", opposite = "M0 0h9v9h-9zM3 3v3h3v-3z";
  EXPECT_DOUBLE_EQ(area(path(same).surface), 81);
  EXPECT_TRUE(has_note(path(same), "1 ring within an area left out"));
  EXPECT_DOUBLE_EQ(area(path(opposite).surface), 72);
  EXPECT_DOUBLE_EQ(area(path(same, "fill-rule='evenodd'").surface), 72);
  EXPECT_DOUBLE_EQ(area(path(same, "style='fill:red; fill-rule : evenodd'").surface), 72);
  EXPECT_DOUBLE_EQ(area(read("<g fill-rule='evenodd'><path d='" + same + "'/></g>").surface), 72);
}

TEST_F(Svg, IdsLabelsAndLayersChoose) {
  const std::string body =
      "<g id='layer1' xmlns:inkscape='i' inkscape:label='Leaves'><path id='a' d='M0 0h2v2h-2z'/><g id='inner'><path "
      "id='b' d='M5 0h3v3h-3z'/></g></g>"
      "<circle id='c' cx='50' r='1'/>";
  const auto chosen = [&](const std::string& name) { return area(read(body, "", ":" + name).surface); };
  EXPECT_DOUBLE_EQ(chosen("a"), 4);
  EXPECT_DOUBLE_EQ(chosen("b"), 9);
  EXPECT_DOUBLE_EQ(chosen("inner"), 9);
  EXPECT_DOUBLE_EQ(chosen("layer1"), 13);
  EXPECT_DOUBLE_EQ(chosen("Leaves"), 13);
  EXPECT_TRUE(has_note(read(body), "3 areas taken together: 'a', 'b', 'c'; FILE:NAME chooses"));
  EXPECT_TRUE(contains(error(body, "", ":d"), "no area is named 'd'; choose one of 'a', 'b', 'c'"));
}

TEST_F(Svg, WhatIsHiddenOrDefinedIsNotDrawn) {
  const std::string drawn = "<path d='M0 0h2v2h-2z'/>";
  const std::string hidden =
      "<defs><path d='M9 9h2v2z'/></defs><clipPath><rect width='9' height='9'/></clipPath><g display='none'>" + drawn +
      "</g>" + "<g style='display:none'>" + drawn + "</g><path visibility='hidden' d='M9 9h2v2z'/><symbol>" + drawn +
      "</symbol>" + "<text>a</text><use href='#a'/><line x1='3'/><path d='M9 9'/><path d='M9 9h3'/><title>a</title>";
  const Shape<2> shape = read(hidden + drawn);
  EXPECT_DOUBLE_EQ(area(shape.surface), 4);
  EXPECT_TRUE(has_note(shape, "left out: line, text, use"));
  EXPECT_TRUE(has_note(shape, "1 line without area left out"));
  EXPECT_TRUE(contains(error(hidden), "what is drawn has no area"));
}

TEST_F(Svg, WhatIsWrongIsSaidWithItsPlace) {
  const auto data = [&](const std::string& d) { return error("<path id='p' d='" + d + "'/>"); };
  EXPECT_TRUE(contains(data("L1 2"), "<path> 'p': at byte 1 of 'L1 2' expected 'M' or 'm'"));
  EXPECT_TRUE(contains(data("1 2"), "expected a letter such as M"));
  EXPECT_TRUE(contains(data("M1 2X"), "expected after it one of M, L"));
  EXPECT_TRUE(contains(data("M1"), "at byte 3 of 'M1' expected a number"));
  EXPECT_TRUE(contains(data("M0 0h1zz1"), "expected a letter"));
  EXPECT_TRUE(contains(data("M0 0a1 1 0 2 0 5 5"), "expected 0 or 1"));
  EXPECT_TRUE(contains(data("M0 0h1e999v1z"), "a coordinate of 'p' is not finite"));
  EXPECT_TRUE(contains(data("M0 0h1e308h1e308v1z"), "a coordinate of 'p' is not finite"));
  EXPECT_TRUE(contains(error("<polygon points='1 2 3'/>"), "expected a number"));
  EXPECT_TRUE(contains(error("<rect width='2em' height='1'/>"), "the unit 'em'"));
  EXPECT_TRUE(contains(error("<g transform='turn(3)'/>"), "the transformation 'turn' with 1 numbers is unknown"));
  EXPECT_TRUE(contains(error("<g transform='scale'/>"), "expected a transformation such as"));
  EXPECT_TRUE(contains(error("<g transform='scale(1;2)'/>"), "expected a number or ')'"));
  EXPECT_TRUE(contains(error("<g/>"), "no area in it"));
  EXPECT_TRUE(contains(input_error_of([&] { read_outline(folder_.write("a.svg", "<html/>")); }),
                       "its element <svg> is missing"));
  EXPECT_TRUE(contains(input_error_of([&] { read_outline(folder_.write("a.svg", "<svg")); }), "no XML at byte"));
  std::string deep = "<rect width='1' height='1'/>";
  for (int k = 0; k < 200; ++k) deep = "<g>" + deep + "</g>";
  EXPECT_TRUE(contains(error(deep), "nested more than 100 deep"));
}

}  // namespace
}  // namespace shellmatch::testing
