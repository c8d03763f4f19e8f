// Motions of the plane from points that they have moved.
#include "alignment/pose/fit_pose.h"
#include "base/error.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

Similarity<2> motion(double angle, double scale, bool mirror) {
  Similarity<2> pose;
  pose.scale = scale;
  pose.offset = Vec<2>(3, -7);
  pose.rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  if (mirror) pose.rotation.col(1) *= -1;
  return pose;
}

std::vector<CorrespondingPointsIn<2>> moved_points(const Similarity<2>& pose) {
  std::vector<CorrespondingPointsIn<2>> pairs;
  for (const Vec<2>& x : test::random_points<2>(20, {-1, 2}, {4, 3}))
    pairs.push_back({x, pose(x), 0.1 + 0.01 * static_cast<double>(pairs.size())});
  return pairs;
}

TEST(PlanarPose, OfMovedPointsIsTheMotion) {
  for (const bool mirror : {false, true})
    for (const double angle : {0.0, 1.0, 3.1, -2.0})
      for (const double scale : {1.0, 2.5}) {
        const Similarity<2> pose = motion(angle, scale, mirror);
        const Similarity<2> found =
            fit_planar_pose(moved_points(pose), scale == 1 ? PoseKind::rigid : PoseKind::similarity,
                            mirror ? Mirroring::always : Mirroring::never);
        EXPECT_NEAR(found.scale, scale, 1e-12);
        EXPECT_LT((found.rotation - pose.rotation).norm(), 1e-12);
        EXPECT_LT((found.offset - pose.offset).norm(), 1e-11);
      }
}

TEST(PlanarPose, HasLeastSquaresAmongItsNeighbours) {
  std::vector<CorrespondingPointsIn<2>> pairs = moved_points(motion(0.7, 1.3, false));
  const std::vector<Vec<2>> noise = test::random_points<2>(20, {-0.4, -0.4}, {0.4, 0.4}, 9);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].on_template += noise[i];
  const auto cost = [&](const Similarity<2>& pose) {
    double sum = 0;
    for (const auto& p : pairs) sum += p.weight * (pose(p.on_reference) - p.on_template).squaredNorm();
    return sum;
  };
  for (const PoseKind kind : {PoseKind::rigid, PoseKind::similarity}) {
    const Similarity<2> found = fit_planar_pose(pairs, kind);
    for (const double step : {-1e-3, 1e-3}) {
      Similarity<2> other = found;
      other.rotation = motion(step, 1, false).rotation * found.rotation;
      EXPECT_GT(cost(other), cost(found));
      for (int k = 0; k < 2; ++k) {
        other = found;
        other.offset[k] += step;
        EXPECT_GT(cost(other), cost(found));
      }
      if (kind == PoseKind::rigid) continue;
      other = found;
      other.scale += step;
      EXPECT_GT(cost(other), cost(found));
    }
  }
}

TEST(PlanarPose, AMirrorOnlyWhereItIsAllowedAndThere) {
  for (const bool mirror : {false, true}) {
    const Similarity<2> pose = motion(0.7, 1, mirror);
    const Similarity<2> found = fit_planar_pose(moved_points(pose), PoseKind::rigid, Mirroring::allowed);
    EXPECT_LT((found.rotation - pose.rotation).norm(), 1e-12);
    EXPECT_GT(fit_planar_pose(moved_points(pose), PoseKind::rigid, Mirroring::never).rotation.determinant(), 0);
  }
  // Points on a line are their own mirror image.
  const std::vector<CorrespondingPointsIn<2>> line{{{0, 0}, {0, 0}, 1}, {{1, 0}, {0, 1}, 1}, {{2, 0}, {0, 2}, 1}};
  EXPECT_GT(fit_planar_pose(line, PoseKind::rigid, Mirroring::allowed).rotation.determinant(), 0);
  // Two points fit both ways, and rounding does not choose.
  for (int k = 0; k < 20; ++k) {
    const Similarity<2> pose = motion(0.3 * k, 1.7, false);
    std::vector<CorrespondingPointsIn<2>> two{{{0.1, 0.7 * k}, {}, 1}, {{1.3, 0.2}, {}, 1}};
    for (auto& pair : two) pair.on_template = pose(pair.on_reference);
    EXPECT_GT(fit_planar_pose(two, PoseKind::similarity, Mirroring::allowed).rotation.determinant(), 0) << k;
  }
}

TEST(PlanarPose, NeedsTwoPointsApart) {
  const CorrespondingPointsIn<2> pair{{1, 1}, {2, 2}, 1};
  EXPECT_THROW(fit_planar_pose(std::vector{pair}, PoseKind::rigid), InputError);
  EXPECT_THROW(fit_planar_pose(std::vector{pair, pair}, PoseKind::rigid), InputError);
}

}  // namespace
}  // namespace shellmatch
