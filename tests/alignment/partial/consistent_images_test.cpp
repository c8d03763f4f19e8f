#include "alignment/partial/consistent_images.h"

#include <gtest/gtest.h>

#include <vector>

namespace shellmatch {
namespace {

// Points of a crooked line with a fork, by their places in the plane.
Eigen::MatrixXf distances_of(const Eigen::Matrix2Xf& points) {
  Eigen::MatrixXf d(points.cols(), points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    d.col(i) = (points.colwise() - points.col(i)).colwise().norm().transpose();
  return d;
}

Eigen::Matrix2Xf whole() {
  Eigen::Matrix2Xf points(2, 9);
  points << 0, 0.3F, 0.7F, 1, 1, 0.9F, 0.4F, 0.1F, 0.5F, 0, 0.1F, 0, 0.2F, 0.6F, 1, 0.8F, 0.5F, 0.4F;
  return points;
}

SampleDistances without_descriptors(const Eigen::MatrixXf& on_part) {
  return {on_part, distances_of(whole()), Eigen::MatrixXf::Zero(on_part.rows(), whole().cols())};
}

Eigen::MatrixXf on_part(const std::vector<int>& at) {
  Eigen::Matrix2Xf points(2, static_cast<Eigen::Index>(at.size()));
  for (std::size_t i = 0; i < at.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = whole().col(at[i]);
  return distances_of(points);
}

const std::vector<int> truth = {5, 2, 7, 3, 8};

TEST(ConsistentImages, DistancesAloneTellWherePointsLie) {
  const auto found = consistent_images(without_descriptors(on_part(truth)), 20);
  ASSERT_GT(found.size(), 1u);
  EXPECT_EQ(found[0].images, truth);
  EXPECT_NEAR(found[0].cost, 0, 1e-6);
  EXPECT_GT(found[1].cost, 0.01);
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_GE(found[i].cost, found[i - 1].cost);
}

// Distances between two points say nothing of their order; surroundings do.
TEST(ConsistentImages, SurroundingsTellWhatDistancesDoNot) {
  SampleDistances samples = without_descriptors(on_part({0, 5}));
  samples.unlikeness(0, 0) = 1;
  const auto found = consistent_images(samples, 20);
  EXPECT_EQ(found[0].images, (std::vector<int>{5, 0}));
}

// As a symmetric body has two sides, of which the wrong one may fit a little better at first.
TEST(ConsistentImages, VariantsOfOneDoNotCrowdOutTheOthers) {
  const Eigen::Index n = 25;  // on either side, 0.13 apart
  Eigen::Matrix2Xf places(2, 2 * n);
  for (Eigen::Index i = 0; i < 2 * n; ++i)
    places.col(i) << (i < n ? -2.0F : 2.0F) + 0.13F * static_cast<float>(i % 5), 0.13F * static_cast<float>(i % n / 5);
  SampleDistances samples{Eigen::MatrixXf::Zero(1, 1), distances_of(places), Eigen::MatrixXf::Zero(1, 2 * n)};
  samples.unlikeness.rightCols(n).setConstant(0.1F);
  const auto found = consistent_images(samples, 20);
  EXPECT_LT(found.front().images[0], n);
  EXPECT_GE(found.back().images[0], n);
}

TEST(ConsistentImages, WaysAroundHolesMayBeLongerButNotShorter) {
  SampleDistances lengthened{Eigen::MatrixXf(2, 2), Eigen::MatrixXf(2, 2), Eigen::MatrixXf::Zero(2, 2)};
  lengthened.on_whole << 0, 0.5F, 0.5F, 0;
  SampleDistances shortened = lengthened;
  lengthened.on_part << 0, 0.6F, 0.6F, 0;
  shortened.on_part << 0, 0.4F, 0.4F, 0;
  EXPECT_LT(2 * consistent_images(lengthened, 1)[0].cost, consistent_images(shortened, 1)[0].cost);
}

}  // namespace
}  // namespace shellmatch
