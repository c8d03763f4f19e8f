// The mean of an atlas' images, in closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "apps/cohorts/execution/atlas.h"

namespace shellmatch {
namespace {

// A square of side 2 about the origin with a landmark at a corner.
Atlas<2> square_atlas(const std::string& folder) {
  OriginalShape<2> square;
  square.vertices = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  square.polygons = {{0, 1, 2, 3}};
  return make_atlas<2>(square, {{"corner", {1, 1}, ""}}, folder, "square");
}

Eigen::VectorXd image(const Atlas<2>& atlas, double factor, double angle, const Vec<2>& offset) {
  const Mat<2> turn{{std::cos(angle), -std::sin(angle)}, {std::sin(angle), std::cos(angle)}};
  Eigen::VectorXd points = atlas.points;
  for (Eigen::Index p = 0; p < points.size() / 2; ++p)
    points.segment<2>(2 * p) = factor * (turn * Vec<2>(points.segment<2>(2 * p))) + offset;
  return points;
}

TEST(MeanAtlas, SizesAreAveragedAndPosesAreNot) {
  const std::string folder = testing::TempDir() + "/shellmatch_mean_atlas";
  const Atlas<2> atlas = square_atlas(folder);
  EXPECT_EQ(atlas.points.size(), 10);
  EXPECT_EQ(atlas.weights[4], 0) << "landmarks weigh nothing";
  PointSets images{2, Eigen::MatrixXd(10, 3)};
  images.coordinates.col(0) = image(atlas, 1.0, 0.5, {3, 4});
  images.coordinates.col(1) = image(atlas, 1.3, -0.7, {-1, 0});
  images.coordinates.col(2) = image(atlas, 1.6, 2.0, {0, 9});
  const MeanAtlas<2> mean = mean_atlas(atlas, images, ProcrustesKind::rigid);
  for (std::size_t v = 0; v < 4; ++v) EXPECT_LT((mean.shape.vertices[v] - 1.3 * atlas.shape.vertices[v]).norm(), 1e-9);
  EXPECT_LT((mean.landmarks[0].point - Vec<2>(1.3, 1.3)).norm(), 1e-9);
  // All corners move by 0.3 root 2, straight away from the corner; the diagonal is 2 root 2.
  EXPECT_NEAR(mean.change, 0.15, 1e-9);
  EXPECT_NEAR(mean.spread, 0.15 * std::sqrt(2. / 3), 1e-9);
  EXPECT_EQ(mean.nearest, 1u);
  const MeanAtlas<2> shape_only = mean_atlas(atlas, images, ProcrustesKind::similarity);
  EXPECT_NEAR(shape_only.change, 0, 1e-9);
  EXPECT_NEAR(shape_only.spread, 0, 1e-9);
  std::filesystem::remove_all(folder);
}

TEST(MeanAtlas, PointsThatSlideAlongTheSurfaceAreNoChange) {
  const std::string folder = testing::TempDir() + "/shellmatch_sliding_atlas";
  OriginalShape<2> square;
  square.vertices = {{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}};
  square.polygons = {{0, 1, 2, 3, 4, 5, 6, 7}};
  const Atlas<2> atlas = make_atlas<2>(square, {}, folder, "square");
  PointSets images{2, atlas.points};
  images.coordinates(2, 0) = 0.3;    // the middle of the lower side
  images.coordinates(10, 0) = -0.3;  // and of the upper one
  EXPECT_NEAR(mean_atlas(atlas, images, ProcrustesKind::none).change, 0, 1e-12);
  std::filesystem::remove_all(folder);
}

TEST(MeanAtlas, AnAtlasIsReadBackAsItWasWritten) {
  const std::string folder = testing::TempDir() + "/shellmatch_read_atlas";
  const Atlas<2> written = square_atlas(folder), read = read_atlas<2>(folder, "square");
  EXPECT_EQ(read.points, written.points);
  EXPECT_EQ(read.weights, written.weights);
  ASSERT_EQ(read.landmarks.size(), 1u);
  EXPECT_EQ(read.landmarks[0].name, "corner");
  EXPECT_TRUE(has_atlas(folder, "square", 2));
  EXPECT_FALSE(has_atlas(folder, "circle", 2));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace shellmatch
