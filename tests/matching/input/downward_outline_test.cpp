// An outline with y downward beside the picture of the same shape; outlines for which that is not so.
#include "matching/input/downward_outline.h"

#include "geometry/repair/make_shape.h"

#include <gtest/gtest.h>

namespace shellmatch::testing {
namespace {

constexpr double height = 120;

Shape<2> outline(std::vector<Vec<2>> points, bool turned = false) {
  OriginalShape<2> original;
  for (Vec<2>& x : points) {
    if (turned) x.y() = height - x.y();
    original.polygons.resize(1);
    original.polygons[0].push_back(static_cast<Index>(original.vertices.size()));
    original.vertices.push_back(x);
  }
  return make_shape(std::move(original), "a.csv");
}

const std::vector<Vec<2>> letter = {{10, 10}, {30, 10}, {30, 90}, {70, 90}, {70, 110}, {10, 110}};

TEST(DownwardOutline, CommonShareIsThatOfAreas) {
  const Shape<2> square = outline({{0, 0}, {2, 0}, {2, 2}, {0, 2}}),
                 shifted = outline({{1, 1}, {3, 1}, {3, 3}, {1, 3}});
  EXPECT_NEAR(common_share(square.surface, square.surface), 1, 1e-12);
  EXPECT_NEAR(common_share(square.surface, shifted.surface), 1.0 / 7, 1e-3);
  EXPECT_EQ(common_share(square.surface, outline({{5, 0}, {6, 0}, {6, 1}}).surface), 0);
}

TEST(DownwardOutline, IsTurnedIntoThePicturesFrame) {
  const Shape<2> picture = outline(letter, true);
  Shape<2> drawn = outline(letter);
  const std::string note = turn_downward_outline(drawn, picture, height);
  EXPECT_NE(note.find("as it lies with y downward (100 % in common"), std::string::npos) << note;
  EXPECT_NEAR(common_share(drawn.surface, picture.surface), 1, 1e-12);
  EXPECT_GT(enclosed_measure(drawn.surface), 0) << "still outward";
  EXPECT_EQ(drawn.original.vertices, picture.original.vertices);
}

TEST(DownwardOutline, ADrawingThatIsTurnedAlreadyIsMoved) {
  const Shape<2> picture = outline(letter, true);
  std::vector<Vec<2>> points = letter;
  for (Vec<2>& x : points) x.y() = -x.y();
  Shape<2> drawn = outline(points);
  drawn.original.frame.y_scale = -1;
  drawn.unit = "mm";
  EXPECT_NE(turn_downward_outline(drawn, picture, height).find("used as y = 120 - y"), std::string::npos);
  EXPECT_EQ(drawn.original.vertices, picture.original.vertices);
  EXPECT_EQ(drawn.original.frame(Vec<2>(3, 20)), Vec<2>(3, 100));
  EXPECT_EQ(drawn.unit, "mm");
  // The same of one that is turned now.
  Shape<2> table = outline(letter);
  turn_downward_outline(table, picture, height);
  EXPECT_EQ(table.original.frame(Vec<2>(3, 20)), Vec<2>(3, 100));
}

TEST(DownwardOutline, StaysWhereItFitsAsItIsOrNowhere) {
  const Shape<2> picture = outline(letter, true);
  Shape<2> same = outline(letter, true), elsewhere = outline({{200, 0}, {300, 0}, {300, 50}});
  EXPECT_EQ(turn_downward_outline(same, picture, height), "");
  EXPECT_EQ(turn_downward_outline(elsewhere, picture, height), "");
  EXPECT_EQ(same.original.vertices, picture.original.vertices);
  // As good either way: a shape that is its own mirror image.
  const std::vector<Vec<2>> box = {{10, 40}, {50, 40}, {50, 80}, {10, 80}};
  Shape<2> symmetric = outline(box);
  EXPECT_EQ(turn_downward_outline(symmetric, outline(box, true), height), "");
}

}  // namespace
}  // namespace shellmatch::testing
