// Poses: exact recovery, wrong pairs, mirrors, what cannot be fitted.
#include "alignment/pose/fit_pose.h"
#include "base/error.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

struct Motion {
  Mat<3> rotation = Eigen::AngleAxisd(2.5, Vec<3>(1, -2, 0.5).normalized()).toRotationMatrix();
  double scale = 1;
  Vec<3> translation = {3, -7, 20};
};

std::vector<CorrespondingPoints> pairs_of(const Motion& motion, int n) {
  std::vector<CorrespondingPoints> pairs;
  for (const Vec<3>& x : test::random_points<3>(n, {-1, -2, -3}, {1, 2, 3}))
    pairs.push_back({x, motion.scale * motion.rotation * x + motion.translation, 1});
  return pairs;
}

void expect_near(const Pose& pose, const Motion& motion, double tolerance) {
  EXPECT_LT((pose.rotation - motion.rotation).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_NEAR(pose.scale, motion.scale, tolerance);
  EXPECT_LT((pose.translation - motion.translation).norm(), 10 * tolerance);
}

TEST(FitPose, ExactPairsGiveTheMotion) {
  const Motion rigid{};
  const Motion similar{.scale = 2.5};
  expect_near(fit_pose(pairs_of(rigid, 20), PoseKind::rigid), rigid, 1e-12);
  const Pose pose = fit_pose(pairs_of(similar, 20), PoseKind::similarity);
  expect_near(pose, similar, 1e-12);
  EXPECT_LT(pose.residual, 1e-12);
  EXPECT_FALSE(pose.is_mirrored());
  const Vec<3> x(1, 2, 3);
  EXPECT_LT((pose.inverse(pose(x)) - x).norm(), 1e-12);
}

TEST(FitPose, ARigidPoseKeepsTheSize) {
  const Pose pose = fit_pose(pairs_of({.scale = 2.5}, 20), PoseKind::rigid);
  EXPECT_EQ(pose.scale, 1);
  EXPECT_LT((pose.rotation - Motion{}.rotation).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(FitPose, TwoFifthsOfThePairsMayBeAnywhere) {
  const Motion motion{.scale = 0.4};
  std::vector<CorrespondingPoints> pairs = pairs_of(motion, 100);
  const std::vector<Vec<3>> anywhere = test::random_points<3>(40, {0, 0, 0}, {9, 9, 9}, 5);
  for (std::size_t i = 0; i < anywhere.size(); ++i) pairs[2 * i].on_template = anywhere[i];
  expect_near(fit_pose(pairs, PoseKind::similarity), motion, 1e-9);
}

TEST(FitPose, NoiseIsAveraged) {
  const Motion motion{};
  std::vector<CorrespondingPoints> pairs = pairs_of(motion, 400);
  const std::vector<Vec<3>> noise = test::random_points<3>(400, Vec<3>::Constant(-0.1), Vec<3>::Constant(0.1), 6);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].on_template += noise[i];
  expect_near(fit_pose(pairs, PoseKind::rigid), motion, 0.01);
}

TEST(FitPose, WeightsCount) {
  const Motion motion{}, other{.translation = {0, 0, 0}};
  std::vector<CorrespondingPoints> pairs = pairs_of(motion, 20), wrong = pairs_of(other, 60);
  for (CorrespondingPoints& p : wrong) p.weight = 0.1;
  pairs.insert(pairs.end(), wrong.begin(), wrong.end());
  expect_near(fit_pose(pairs, PoseKind::rigid), motion, 1e-9);
}

TEST(FitPose, AMirrorOnlyWhereItIsAllowedAndThere) {
  Motion motion;
  motion.rotation = motion.rotation * Vec<3>(-1, 1, 1).asDiagonal();
  const std::vector<CorrespondingPoints> pairs = pairs_of(motion, 50);
  const Pose proper = fit_pose(pairs, PoseKind::rigid);
  EXPECT_FALSE(proper.is_mirrored());
  EXPECT_GT(proper.residual, 0.1);
  const Pose mirrored = fit_pose(pairs, PoseKind::rigid, Mirroring::allowed);
  EXPECT_TRUE(mirrored.is_mirrored());
  expect_near(mirrored, motion, 1e-12);
  EXPECT_FALSE(fit_pose(pairs_of({}, 50), PoseKind::rigid, Mirroring::allowed).is_mirrored());
}

TEST(FitPose, PointsInAPlaneAreEnoughThoseOnALineAreNot) {
  const Motion motion{};
  std::vector<CorrespondingPoints> flat = pairs_of(motion, 30);
  for (CorrespondingPoints& p : flat) {
    p.on_reference[2] = 0;
    p.on_template = motion.rotation * p.on_reference + motion.translation;
  }
  expect_near(fit_pose(flat, PoseKind::rigid), motion, 1e-12);
  for (std::size_t n = 3; n < flat.size(); ++n)
    EXPECT_FALSE(fit_pose(std::span(flat).first(n), PoseKind::rigid, Mirroring::allowed).is_mirrored())
        << "their own mirror image";
  for (CorrespondingPoints& p : flat) {
    p.on_reference[1] = 0;
    p.on_template = motion.rotation * p.on_reference + motion.translation;
  }
  EXPECT_THROW(fit_pose(flat, PoseKind::rigid), InputError);
  EXPECT_THROW(fit_pose(std::span(flat).first(2), PoseKind::rigid), InputError);
}

}  // namespace
}  // namespace shellmatch
