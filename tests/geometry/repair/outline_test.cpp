// Outlines as text: layouts, rings, orientation by nesting, crossings.
#include "geometry/io/read_shape.h"
#include "tests/geometry/io/files.h"

#include <cmath>
#include <numbers>
#include <random>

namespace shellmatch::testing {
namespace {

Shape<2> outline(const std::string& text, const std::string& name = "a.csv") {
  const TempFolder folder;
  return read_outline(folder.write(name, text));
}

std::string message(const std::string& text) {
  return input_error_of([&] { outline(text); });
}

std::string square(double corner, double side, bool clockwise) {
  const double a = corner, b = corner + side;
  return clockwise ? fmt::format("{0} {0}\n{0} {1}\n{1} {1}\n{1} {0}\n", a, b)
                   : fmt::format("{0} {0}\n{1} {0}\n{1} {1}\n{0} {1}\n", a, b);
}

TEST(Outline, AllLayoutsReadTheSame) {
  for (const std::string text : {"0,0\n2,0\n2,1\n0,1\n", "x,y\n0, 0\n2, 0\n2, 1\n0, 1\n",
                                 "0\t0\r\n2\t0\r\n2\t1\r\n0\t1", "# c\n0;0\n2;0 # d\n#\n2;1\n0;1\n\n\n",
                                 "\n\n  0   0\n  2.0 0\n 2e0 1\n +0 1\n 0 0\n", "\"Y\";\"X\"\n0;0\n0;2\n1;2\n1;0\n",
                                 "\xEF\xBB\xBF"
                                 "0 0\n2 0\n2 1\n0 1\n"}) {
    const Shape<2> shape = outline(text);
    ASSERT_EQ(shape.original.vertices.size(), 4u) << text;
    EXPECT_EQ(shape.original.vertices[1], Vec<2>(2, 0));
    EXPECT_EQ(shape.surface.facets.size(), 4u);
    EXPECT_DOUBLE_EQ(area(shape.surface), 2);
  }
}

TEST(Outline, AClosingPointGoesWithItsColumns) {
  const Shape<2> shape = outline("x,y,label\n0,0,1\n2,0,2\n0,1,3\n0,0,4\n\n5,5,5\n6,5,6\n5,6,7\n");
  ASSERT_EQ(shape.original.vertices.size(), 6u);
  EXPECT_EQ(shape.original.attributes.at(0).values, (std::vector<double>{1, 2, 3, 5, 6, 7}));
}

TEST(Outline, OrientationFollowsTheDepthOfNesting) {
  for (int turned = 0; turned < 16; ++turned) {
    const std::string text = square(4, 2, turned & 1) + "\n" + square(0, 10, turned & 2) + "\n" +
                             square(1, 8, turned & 4) + "\n" + square(20, 1, turned & 8);
    const Shape<2> shape = outline(text, "a.txt");
    EXPECT_DOUBLE_EQ(area(shape.surface), 100 - 64 + 4 + 1);
    EXPECT_EQ(shape.original.polygons.size(), 4u);
    EXPECT_TRUE(has_note(shape, "1 ring is a hole"));
  }
}

TEST(Outline, CrossingsAreNamed) {
  const std::string text = message("0 0\n2 2\n2 0\n0 2\n");
  EXPECT_TRUE(contains(text, "in 1 place: segments 1-2 and 3-4 at (1, 1)"));
  EXPECT_TRUE(contains(message(square(0, 2, false) + "\n" + square(1, 2, false)),
                       "in 2 places: segments 2-3 and 5-6 at (2, 1)"));
  EXPECT_TRUE(contains(message(square(0, 2, false) + "\n" + square(0, 2, false)), "crosses or touches"));
}

// The two rings meet in two points of both, where one goes into the other and comes out again.
TEST(Outline, RingsThatCrossAtCommonPointsAreRefused) {
  const std::string rectangle = "0 0\n-24 0\n-24 -10\n0 -10\n";
  for (const std::string triangle : {"0 0\n-30 1\n-24 -10\n", "-24 -10\n-30 1\n0 0\n", "-30 1\n0 0\n-24 -10\n"})
    for (const std::string& text : {rectangle + "\n" + triangle, triangle + "\n" + rectangle}) {
      const std::string said = message(text);
      EXPECT_TRUE(contains(said, "two rings cross at (-24, -10), which is a point of both")) << said;
    }
  // From outside, from inside, and past a straight edge they touch.
  EXPECT_DOUBLE_EQ(area(outline(rectangle + "\n0 0\n5 1\n5 0\n").surface), 242.5);
  EXPECT_DOUBLE_EQ(area(outline(rectangle + "\n0 0\n-24 -10\n-10 -8\n").surface), 240 - 46);
  EXPECT_DOUBLE_EQ(area(outline(rectangle + "\n-12 0\n-10 5\n-14 5\n").surface), 250);
}

TEST(Outline, WhereItTouchesItselfItIsCutInTwo) {
  const Shape<2> eight = outline("0 0\n1 1\n2 0\n2 2\n1 1\n0 2\n");
  EXPECT_DOUBLE_EQ(area(eight.surface), 2);
  EXPECT_TRUE(has_note(eight, "1 loop cut off"));
  const Shape<2> tongue = outline("0 0\n4 0\n4 4\n2 4\n2 0\n1 4\n0 4\n");  // point 5 lies on the first segment
  EXPECT_DOUBLE_EQ(area(tongue.surface), 16 - 2);
  const Shape<2> spike = outline("0 0\n2 0\n4 0\n3 0\n2 0\n2 1\n0 1\n");
  EXPECT_DOUBLE_EQ(area(spike.surface), 2);
  EXPECT_TRUE(has_note(spike, "without width removed"));
}

TEST(Outline, NumbersWhoseProductsVanishAreZero) {
  // A loop of the size of the smallest number beside a triangle, which would lie within it.
  const Shape<2> shape =
      outline("0 5e-324\n5e-324 5e-324\n5e-324 1e-323\n0 1e-323\n5e-324 5e-324\n4 4\n-28 2\n4 -30.5\n");
  EXPECT_DOUBLE_EQ(area(shape.surface), 483);
}

TEST(Outline, TooSmallWithoutItsSpike) {
  const std::string said = message("0 0\n1e-60 0\n1e-60 1e-60\n0 1e-60\n-30 1e-60\n0 1e-60\n");
  EXPECT_TRUE(contains(said, "the mended shape has a size of 1e-60, and sizes from 1e-50 on can be used")) << said;
}

TEST(Outline, BadTextIsRefusedWithItsLine) {
  EXPECT_TRUE(contains(message("0 0\n1 0\n1 x\n"), "line 3: a column should be a number, not 'x'"));
  EXPECT_TRUE(contains(message("0 0\n1 0 3\n"), "line 2: 3 columns, the lines above have 2"));
  EXPECT_TRUE(contains(message("0 0 1\n1 0 1\n"), "line 1: 3 columns"));
  EXPECT_TRUE(contains(message("x,y,z\n0,0,1\n"), "line 1: there is a column z"));
  EXPECT_TRUE(contains(message("0,0\n1,\n"), "line 2: 1 column,"));
  EXPECT_TRUE(contains(message("0,,1\n"), "line 1: a column is empty"));
  EXPECT_TRUE(contains(message("0 0\n1 0\nnan 1\n"), "line 3: the point has a coordinate that is not finite"));
  EXPECT_TRUE(contains(message("0 0\n1 0\n"), "ring 1 has only 2 different points"));
  EXPECT_TRUE(contains(message("0 0\n1 0\n2 0\n"), "no area"));
  EXPECT_TRUE(contains(message(square(0, 1, false) + "\n9 9\n"), "ring 2 has only 1 different point (point 5 on)"));
  EXPECT_TRUE(contains(message("# nothing\n"), "no points"));
}

TEST(Outline, CrossingsAgreeWithBruteForceOnRandomOutlines) {
  std::mt19937 random(3);
  int n_crossing = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vec<2>> x;
    for (int i = 0; i < 5; ++i) x.emplace_back(random() % 1000, random() % 1000);
    const auto turn = [](const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
      return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    };
    bool crossing = false;
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = i + 2; j < 5 && j < i + 4; ++j) {
        const Vec<2>&a = x[i], &b = x[(i + 1) % 5], &c = x[j], &d = x[(j + 1) % 5];
        crossing = crossing || (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0);
      }
    std::string text;
    for (const Vec<2>& p : x) text += fmt::format("{} {}\n", p.x(), p.y());
    EXPECT_EQ(!message(text).empty(), crossing) << text;
    n_crossing += crossing ? 1 : 0;
  }
  EXPECT_GT(n_crossing, 20);
  EXPECT_LT(n_crossing, 180);
}

// Triangles around one corner: their pairs would take time with the square of their number.
TEST(Outline, ManyRingsMayMeetInAPointButNotAnyNumber) {
  const auto star = [](int n) {
    std::string text;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n, next = 2 * std::numbers::pi * (k + 0.5) / n;
      text += fmt::format("0 0\n{} {}\n{} {}\n\n", std::cos(angle), std::sin(angle), std::cos(next), std::sin(next));
    }
    return text;
  };
  EXPECT_EQ(outline(star(1000)).original.polygons.size(), 1000u);
  EXPECT_TRUE(
      contains(input_error_of([&] { outline(star(1001)); }), "the outline passes through (0, 0) more than 1000 times"));
}

}  // namespace
}  // namespace shellmatch::testing
