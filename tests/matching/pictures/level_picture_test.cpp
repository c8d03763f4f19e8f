#include "matching/pictures/level_picture.h"
#include "matching/render/canvas/image.h"
#include "tests/matching/output/temporary_folder.h"
#include "tests/matching/render/test_shapes.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace shellmatch {
namespace {

using testing::circle;
using testing::sphere;
using testing::TemporaryFolder;

// Share of pixels that are not white, between two columns of the picture.
double covered(const Image& image, double from, double to) {
  long n = 0, all = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = static_cast<int>(from * image.width); x < static_cast<int>(to * image.width); ++x, ++all)
      n += image.at(x, y)[0] + image.at(x, y)[1] + image.at(x, y)[2] < 740;
  return static_cast<double>(n) / static_cast<double>(all);
}

TEST(LevelPictureTest, EveryPanelInSpaceShowsSomething) {
  const TemporaryFolder tmp;
  const Surface<3> a = sphere(60, 0.3, Vec<3>::Constant(0.5));
  Surface<3> b = a, c = a;
  for (Vec<3>& v : b.vertices) v.x() = 0.5 + 1.3 * (v.x() - 0.5);
  for (Vec<3>& v : c.vertices) v.x() = 0.5 + 1.28 * (v.x() - 0.5);
  LevelPicture<3> picture{.reference = &a, .template_shape = &b, .deformed = &c, .title = "level 5", .panel_size = 120};
  for (std::size_t i = 0; i < a.vertices.size(); ++i)
    picture.distance.push_back((b.vertices[i] - c.vertices[i]).norm());
  write_level_picture(picture, tmp / "p.png");
  const Image image = read_png(tmp / "p.png");
  for (int k = 0; k < 5; ++k) EXPECT_GT(covered(image, k / 5.0, (k + 1) / 5.0), 0.1) << k;
}

TEST(LevelPictureTest, ThePlaneShowsTheDeformedGridToo) {
  const TemporaryFolder tmp;
  const Surface<2> a = circle(200, 0.25, {0.5, 0.5});
  Surface<2> b = a;
  for (Vec<2>& v : b.vertices) v.y() += 0.05 * std::sin(10 * v.x());
  Octree<2> grid(3);
  for (int i = 0; i < 3; ++i)
    grid.refine([&](Index c) {
      return std::abs((grid.cell_centre(c) - Vec<2>(0.5, 0.5)).norm() - 0.25) < grid.cell(c).side();
    });
  std::vector<Vec<2>> phi;
  for (Index i = 0; i < grid.n_nodes(); ++i) {
    Vec<2> x = grid.node_position(i);
    x.y() += 0.05 * std::sin(10 * x.x());
    phi.push_back(x);
  }
  LevelPicture<2> picture{
      .reference = &a, .template_shape = &b, .deformed = &b, .title = "level 6", .grid = &grid, .phi = &phi};
  for (std::size_t i = 0; i < a.vertices.size(); ++i) picture.distance.push_back(1e-4 * static_cast<double>(i % 50));
  write_level_picture(picture, tmp / "with.png");
  const Image with = read_png(tmp / "with.png");
  for (int k = 0; k < 4; ++k) EXPECT_GT(covered(with, k / 4.0, (k + 1) / 4.0), 0.02) << k;
  picture.phi = nullptr;
  write_level_picture(picture, tmp / "undeformed.png");
  EXPECT_LT(read_png(tmp / "undeformed.png").width, with.width);  // six panels instead of seven
  picture.grid = nullptr;
  write_level_picture(picture, tmp / "without.png");
  EXPECT_LT(read_png(tmp / "without.png").height, with.height);  // one row less
}

TEST(LevelPictureTest, NamesSortByLevel) {
  EXPECT_EQ(level_picture_name(5), "pictures/level_05.png");
  EXPECT_LT(level_picture_name(9), level_picture_name(10));
}

}  // namespace
}  // namespace shellmatch
