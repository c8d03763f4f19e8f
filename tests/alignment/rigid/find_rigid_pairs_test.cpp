// Poses of ellipsoids, blobs and boxes that were turned; what is symmetric stays.
#include "alignment/rigid/find_rigid_pairs.h"
#include "base/error.h"
#include "base/parallel.h"
#include "geometry/generate/round.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <random>

namespace shellmatch {
namespace {

Surface<3> ellipsoid(const Vec<3>& axes, int frequency = 12) {
  Surface<3> surface = geodesic_sphere(frequency);
  for (Vec<3>& x : surface.vertices) x = axes.cwiseProduct(x);
  return surface;
}

/// An ellipsoid with one bump on a side: no motion carries it onto itself.
Surface<3> blob(int frequency = 12) {
  Surface<3> surface = geodesic_sphere(frequency);
  const Vec<3> top = Vec<3>(1, 0.7, 0.4).normalized();
  for (Vec<3>& x : surface.vertices)
    x = Vec<3>(1.3, 1.1, 0.9).cwiseProduct((1 + 0.25 * std::exp(-4 * (x - top).squaredNorm())) * x);
  return surface;
}

Mat<3> rotation_about(double degrees, const Vec<3>& axis) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
}

Surface<3> moved_by(const Surface<3>& surface, const Mat<3>& rotation, double scale = 1,
                    const Vec<3>& offset = Vec<3>::Zero()) {
  return test::mapped<3>(surface, [&](const Vec<3>& x) { return Vec<3>(scale * (rotation * x) + offset); });
}

double degrees_between(const Mat<3>& a, const Mat<3>& b) {
  return std::acos(std::clamp(((a.transpose() * b).trace() - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
}

double greatest_error(const RigidPairs& found, const Surface<3>& other, const Mat<3>& rotation, double scale,
                      const Vec<3>& offset) {
  double greatest = 0;
  for (const CorrespondingPoints& pair : found.pairs())
    greatest = std::max(greatest, (scale * (rotation * pair.on_reference) + offset - pair.on_template).norm());
  return greatest / bounding_box(other.vertices).diagonal();
}

TEST(FindRigidPairs, ATurnedBlobIsFoundWhateverTheTurn) {
  std::mt19937 random(3);
  const auto number = [&] { return random() / 4294967296.0 - 0.5; };
  const Surface<3> reference = blob();
  for (int trial = 0; trial < 4; ++trial) {
    const Mat<3> rotation = rotation_about(30 + 45 * trial, Vec<3>(number(), number(), number()));
    const Vec<3> offset(3, -4, 5);
    const Surface<3> other = moved_by(blob(15), rotation, 7, offset);
    const RigidPairs found = find_rigid_pairs(reference, other);
    EXPECT_LT(degrees_between(found.candidates[0].pose.rotation, rotation), 1) << trial;
    EXPECT_NEAR(found.candidates[0].pose.scale, 7, 0.03);
    EXPECT_LT(greatest_error(found, other, rotation, 7, offset), 0.02);
    EXPECT_GE(found.pairs().size(), 290u);
    EXPECT_LT(found.candidates[0].pose.residual, 0.02 * 7);
    EXPECT_GT(found.margin, 2);
    EXPECT_TRUE(std::isfinite(found.margin));
  }
}

TEST(FindRigidPairs, FewerSweepsEndNearTheSamePose) {
  const Mat<3> rotation = rotation_about(75, {1, -2, 0.5});
  const Surface<3> reference =
      test::mapped<3>(blob(), [](const Vec<3>& x) { return Vec<3>(x.x(), x.y() + 0.3 * x.x() * x.x(), x.z()); });
  const Surface<3> other = moved_by(blob(15), rotation);
  const auto pose = [&](int n_sweeps) { return find_rigid_pairs(reference, other, {}, n_sweeps).candidates[0].pose; };
  const double apart = degrees_between(pose(0).rotation, pose(28).rotation);
  EXPECT_LT(apart, 20);
  EXPECT_GT(apart, 1e-3);
}

TEST(FindRigidPairs, ATurnedEllipsoidTurnsByTheLeastOfItsFourTurns) {
  const Vec<3> axes(1.5, 1.2, 1);
  for (const double angle : {50.0, 80.0, 130.0}) {
    const Mat<3> rotation = rotation_about(angle, Vec<3>(1, 2, 0.5));
    const RigidPairs found = find_rigid_pairs(ellipsoid(axes), moved_by(ellipsoid(axes, 15), rotation));
    double least = 180, nearest = 180;
    for (const Vec<3>& half : {Vec<3>(1, 1, 1), Vec<3>(1, -1, -1), Vec<3>(-1, 1, -1), Vec<3>(-1, -1, 1)}) {
      const Mat<3> turn = rotation * half.asDiagonal();
      least = std::min(least, degrees_between(turn, Mat<3>::Identity()));
      nearest = std::min(nearest, degrees_between(turn, found.candidates[0].pose.rotation));
    }
    EXPECT_LT(nearest, 1.5) << angle;
    EXPECT_NEAR(degrees_between(found.candidates[0].pose.rotation, Mat<3>::Identity()), least, 1.5) << angle;
    EXPECT_GT(found.margin, 2) << angle;
  }
}

TEST(FindRigidPairs, WhatIsSymmetricStaysAsItLies) {
  const Mat<3> none = Mat<3>::Identity();
  for (const Surface<3>& shape :
       {ellipsoid({1, 1, 1}), ellipsoid({1.4, 1.2, 1}), ellipsoid({2, 1, 1}), test::box({-1, -1, -1}, {1, 1, 1})}) {
    const Surface<3> other = moved_by(shape, none, 1.3, {1, 2, 3});
    const RigidPairs found = find_rigid_pairs(shape, other);
    EXPECT_TRUE(found.candidates[0].is_identity);
    EXPECT_LT(degrees_between(found.candidates[0].pose.rotation, none), 1e-4);
    EXPECT_LT(greatest_error(found, other, none, 1.3, {1, 2, 3}), 1e-6);
  }
  // A sphere triangulated otherwise does not turn, either.
  const RigidPairs found = find_rigid_pairs(ellipsoid({1, 1, 1}), test::unit_sphere(4));
  EXPECT_TRUE(found.candidates[0].is_identity);
  EXPECT_LT(degrees_between(found.candidates[0].pose.rotation, none), 2);
}

TEST(FindRigidPairs, AMirroredBlobNeedsMirror) {
  Surface<3> other = moved_by(blob(), rotation_about(100, {1, 0, 2}));
  for (Vec<3>& x : other.vertices) x.y() *= -1;
  other = test::reversed(other);
  AlignmentOptions options;
  const double proper = find_rigid_pairs(blob(), other, options).candidates[0].score;
  options.mirror = true;
  const RigidPairs found = find_rigid_pairs(blob(), other, options);
  EXPECT_TRUE(found.candidates[0].is_mirrored);
  EXPECT_TRUE(found.candidates[0].pose.is_mirrored());
  EXPECT_GT(proper, 3 * found.candidates[0].score);
  EXPECT_LT(found.candidates[0].pose.residual, 1e-2);
  const RigidPairs same = find_rigid_pairs(blob(), blob(), options);
  EXPECT_FALSE(same.candidates[0].is_mirrored);
  EXPECT_TRUE(same.candidates[0].is_identity);
}

TEST(FindRigidPairs, ThreadsDoNotChangeTheResult) {
  const Surface<3> other = moved_by(blob(8), rotation_about(70, {1, 1, 2}));
  set_n_threads(1);
  const RigidPairs one = find_rigid_pairs(blob(), other);
  set_n_threads(3);
  const RigidPairs three = find_rigid_pairs(blob(), other);
  set_n_threads(0);
  ASSERT_EQ(one.candidates.size(), three.candidates.size());
  for (std::size_t k = 0; k < one.candidates.size(); ++k) EXPECT_EQ(one.candidates[k].score, three.candidates[k].score);
}

TEST(FindRigidPairs, WhatHasNoAreaIsRefused) {
  EXPECT_THROW(find_rigid_pairs(blob(), {{Vec<3>::Zero()}, {{0, 0, 0}}}), InputError);
}

}  // namespace
}  // namespace shellmatch
