// Pairs that err systematically are made more exact by landmarks; what contradicts them altogether changes none.

#include "matching/alignment/correct_pairs.h"

#include "geometry/generate/round.h"
#include "matching/alignment/known_pairs.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

const Vec<3> centre = Vec<3>::Constant(0.5);
constexpr double radius = 0.3;

/// Evenly on the sphere.
std::vector<Vec<3>> sphere_points(int n) {
  std::vector<Vec<3>> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z), angle = i * EIGEN_PI * (3 - std::sqrt(5.0));
    points.push_back(centre + radius * Vec<3>(r * std::cos(angle), r * std::sin(angle), z));
  }
  return points;
}

class CorrectPairs : public ::testing::Test {
 protected:
  CorrectPairs() {
    const Mat<3> turn = Eigen::AngleAxisd(0.2, Vec<3>::UnitZ()).toRotationMatrix();
    for (const Vec<3>& p : sphere_points(400)) pairs_.push_back({p, centre + turn * (p - centre)});
    for (const Vec<3>& p : sphere_points(60)) landmarks_.push_back({p, p});
  }

  std::vector<PointPair<3>> corrected(double share) const {
    std::vector<PointPair<3>> pairs = pairs_;
    correct_pairs(pairs, landmarks_, share, sphere_, sphere_);
    return pairs;
  }

  static double mean_error(const std::vector<PointPair<3>>& pairs) {
    double sum = 0;
    for (const PointPair<3>& pair : pairs) sum += (pair.y - pair.p).norm();
    return sum / static_cast<double>(pairs.size());
  }

  std::vector<PointPair<3>> pairs_, landmarks_;  // all pairs are turned too far by the same angle
  SignedDistance<3> sphere_{sphere_surface()};

 private:
  static Surface<3> sphere_surface() {
    Surface<3> sphere = geodesic_sphere(12);
    for (Vec<3>& x : sphere.vertices) x = centre + radius * x.normalized();
    return sphere;
  }
};

TEST_F(CorrectPairs, FollowLandmarksByTheShareAskedFor) {
  EXPECT_LT(mean_error(corrected(1)), 0.25 * mean_error(pairs_));
  EXPECT_NEAR(mean_error(corrected(0.5)), 0.5 * (mean_error(corrected(1)) + mean_error(pairs_)),
              0.05 * mean_error(pairs_));
  EXPECT_EQ(mean_error(corrected(0)), mean_error(pairs_));
}

TEST_F(CorrectPairs, StayOnTheTemplate) {
  for (const PointPair<3>& pair : corrected(1)) EXPECT_NEAR(sphere_(pair.y), 0, 1e-12);
}

TEST_F(CorrectPairs, LandmarksFarFromWhereThePairsHaveThemChangeNone) {
  const std::vector<PointPair<3>> before = corrected(1);
  landmarks_[0].y = 2 * centre - landmarks_[0].p;  // on the other side
  const std::vector<PointPair<3>> after = corrected(1);
  EXPECT_LT(mean_error(after), 1.1 * mean_error(before));
  for (PointPair<3>& landmark : landmarks_) landmark.y = 2 * centre - landmark.p;
  EXPECT_EQ(mean_error(corrected(1)), mean_error(pairs_));
}

TEST_F(CorrectPairs, WhatIsNearOnOneShapeOnlyIsNotMoved) {
  pairs_.push_back({landmarks_[5].p, 2 * centre - landmarks_[5].p});
  EXPECT_LT((corrected(1).back().y - pairs_.back().y).norm(), 0.02 * radius);
}

TEST_F(CorrectPairs, AreThoseOfShapesFarFromIsometric) {
  Alignment<3> alignment;
  for (const PointPair<3>& pair : pairs_) alignment.pairs.push_back({"", pair.p, pair.y});
  std::vector<Landmark<3>> landmarks;
  for (const PointPair<3>& pair : landmarks_) landmarks.push_back({"", pair.p, pair.y});
  const auto error_with = [&](double spread) {
    alignment.spread = spread;
    return mean_error(
        known_pairs<3>(landmarks, alignment, ExperimentOptions(), {}, sphere_, sphere_).back().pairs.pairs);
  };
  EXPECT_EQ(error_with(1), mean_error(pairs_));
  EXPECT_NEAR(error_with(2), mean_error(corrected(0.75)), 1e-12);
  // Pairs that were found with landmarks know them.
  alignment.landmark_trust = 0.5;
  EXPECT_EQ(error_with(2), mean_error(pairs_));
  const ExperimentOptions options;
  EXPECT_EQ(known_pairs<3>(landmarks, alignment, options, {}, sphere_, sphere_).front().factor,
            0.5 * options.landmarks.weight);
  alignment.landmark_trust.reset();
  landmarks.clear();
  EXPECT_EQ(error_with(2), mean_error(pairs_));
}

// A sphere alone, and beside another one: only where nothing lies far apart are pairs that begin far taken for wrong.
TEST_F(CorrectPairs, CountLessWhereTheyBeginFarAndTheShapesDoNot) {
  Alignment<3> alignment;
  for (const PointPair<3>& pair : pairs_) alignment.pairs.push_back({"", pair.p, pair.y});
  Surface<3> two = sphere_.surface();
  const double diagonal = bounding_box(two.vertices).diagonal();
  const auto n = static_cast<Index>(two.vertices.size());
  for (Index v = 0; v < n; ++v) two.vertices.push_back(two.vertices[v] + Vec<3>(diagonal, 0, 0));
  for (const auto& [a, b, c] : sphere_.surface().facets) two.facets.push_back({a + n, b + n, c + n});
  const SignedDistance<3> elsewhere(two);
  const PointPairs<3> near = known_pairs<3>({}, alignment, ExperimentOptions(), {}, sphere_, sphere_).back().pairs,
                      far = known_pairs<3>({}, alignment, ExperimentOptions(), {}, sphere_, elsewhere).back().pairs;
  EXPECT_EQ(near.loss, RobustLoss::cauchy);
  EXPECT_EQ(far.loss, RobustLoss::trivial);
}

}  // namespace
}  // namespace shellmatch
