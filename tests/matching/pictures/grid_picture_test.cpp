#include "matching/pictures/grid_picture.h"
#include "matching/render/canvas/image.h"
#include "tests/grid/test_grids.h"
#include "tests/matching/output/temporary_folder.h"
#include "tests/matching/render/test_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

double length(const SliceLines& lines) {
  double sum = 0;
  for (const auto& [a, b] : lines) sum += (b - a).norm();
  return sum;
}

// The cells that a plane cuts tile the unit square: their areas add up to 1 whatever their sizes.
TEST(GridPicture, SlicesOfTheGridTileTheSquare) {
  const auto grid = test::sphere_grid<3>(2, 4, 0.3, Vec<3>::Constant(0.5));
  for (int axis = 0; axis < 3; ++axis)
    for (const double place : {0.0, 0.25, 0.5, 0.61, 0.999}) {
      const SliceLines lines = slice_grid(grid, axis, place);
      ASSERT_EQ(lines.size() % 4, 0u);
      double area = 0, smallest = 1;
      for (std::size_t i = 0; i < lines.size(); i += 4) {
        const double side = (lines[i][1] - lines[i][0]).norm();
        area += side * side;
        smallest = std::min(smallest, side);
      }
      EXPECT_NEAR(area, 1, 1e-12) << axis << ' ' << place;
      EXPECT_EQ(smallest, place == 0.5 || place == 0.61 ? 1.0 / 16 : smallest);
    }
}

TEST(GridPicture, SlicesOfASphereAreCircles) {
  const Surface<3> ball = testing::sphere(120, 0.3, Vec<3>(0.4, 0.5, 0.6));
  for (const double off : {0.0, 0.1, -0.2}) {
    const double radius = std::sqrt(0.09 - off * off);
    for (int axis = 0; axis < 3; ++axis) {
      const double middle = axis == 0 ? 0.4 : axis == 1 ? 0.5 : 0.6;
      const SliceLines circle = slice_surface(ball, axis, middle + off);
      EXPECT_NEAR(length(circle), 2 * std::numbers::pi * radius, 0.01);
      const Vec<2> centre = axis == 0 ? Vec<2>(0.5, 0.6) : axis == 1 ? Vec<2>(0.4, 0.6) : Vec<2>(0.4, 0.5);
      for (const auto& [a, b] : circle) EXPECT_NEAR((a - centre).norm(), radius, 2e-3);
    }
  }
  EXPECT_TRUE(slice_surface(ball, 0, 0.8).empty());
}

TEST(GridPicture, IsWritten) {
  const testing::TemporaryFolder tmp;
  const auto grid = test::sphere_grid<3>(2, 4, 0.3, Vec<3>::Constant(0.5));
  const Surface<3> ball = testing::sphere(40, 0.3, Vec<3>::Constant(0.5));
  write_grid_picture(grid, ball, ball, "level 4", tmp / "grid.png");
  EXPECT_GT(read_png(tmp / "grid.png").width, 1500);
}

}  // namespace
}  // namespace shellmatch
