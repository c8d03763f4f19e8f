// Functional maps, rotations and scores of maps that are known.
#include "alignment/functional_map/map_score.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace shellmatch {
namespace {

/// Without any symmetry.
Vec<3> pear(const Vec<3>& x) {
  return {1.6 * x[0], x[1] * (1 + 0.3 * x[0]), 0.8 * x[2] + 0.3 * x[0] * x[0] + 0.2 * x[1] * x[0]};
}

class KnownMap : public testing::Test {
 protected:
  KnownMap() {
    options_.functions = 40;
    const Surface<3> surface = test::mapped<3>(test::unit_sphere(4), pear);
    turn_ = Eigen::AngleAxisd(2, Vec<3>(1, 2, 3).normalized()).toRotationMatrix();
    shape_1_ = std::make_unique<SpectralShape>(make_spectral_shape(surface, options_));
    shape_2_ = std::make_unique<SpectralShape>(
        make_spectral_shape(test::mapped<3>(surface, [&](const Vec<3>& x) { return Vec<3>(turn_ * x); }), options_));
    pair_ = make_shape_pair(*shape_1_, *shape_2_);
    for (int s = 0; s < 2; ++s) {
      truth_.from[s] = pair_.shapes[s]->samples;
      truth_.to[s] = pair_.shapes[s]->samples;
    }
  }

  AlignmentOptions options_;
  Mat<3> turn_;
  std::unique_ptr<SpectralShape> shape_1_, shape_2_;
  ShapePairSpectra pair_;
  VertexMatches truth_;
};

TEST_F(KnownMap, TheFunctionalMapCarriesFunctionsThroughIt) {
  const Eigen::MatrixXd c = functional_map(pair_, truth_, 20);
  // An isometry's is orthogonal.
  EXPECT_LT((c * c.transpose() - Eigen::MatrixXd::Identity(20, 20)).cwiseAbs().maxCoeff(), 1e-4);
  const Eigen::MatrixXd carried = shape_1_->functions.leftCols(20) * c;
  EXPECT_LT((carried - shape_2_->functions.leftCols(20)).cwiseAbs().maxCoeff(), 1e-4);
}

TEST_F(KnownMap, TheOrthogonalMapIsOrthogonalForAnyPairsAndTheSameForTrueOnes) {
  EXPECT_LT((orthogonal_map(pair_, truth_, 20) - functional_map(pair_, truth_, 20)).cwiseAbs().maxCoeff(), 1e-4);
  VertexMatches wrong = truth_;
  for (int s = 0; s < 2; ++s) std::rotate(wrong.to[s].begin(), wrong.to[s].begin() + 100, wrong.to[s].end());
  const Eigen::MatrixXd c = orthogonal_map(pair_, wrong, 20);
  EXPECT_LT((c * c.transpose() - Eigen::MatrixXd::Identity(20, 20)).cwiseAbs().maxCoeff(), 1e-10);
}

TEST_F(KnownMap, TheFunctionalMapLiesBetweenBothLeastSquaresProblems) {
  // Pairs that no matrix fits.
  VertexMatches wrong = truth_;
  for (int s = 0; s < 2; ++s) std::rotate(wrong.to[s].begin(), wrong.to[s].begin() + 100, wrong.to[s].end());
  const int k = 12;
  const auto pairs = pairs_of(wrong);
  Eigen::MatrixXd a(pairs.size(), k), b(pairs.size(), k);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    a.row(static_cast<Eigen::Index>(i)) = shape_1_->functions.row(pairs[i].first).head(k);
    b.row(static_cast<Eigen::Index>(i)) = shape_2_->functions.row(pairs[i].second).head(k);
  }
  const Eigen::MatrixXd forward = a.colPivHouseholderQr().solve(b), backward = b.colPivHouseholderQr().solve(a);
  EXPECT_LT((functional_map(pair_, wrong, k) - 0.5 * (forward + backward.transpose())).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_GT((forward - backward.transpose()).cwiseAbs().maxCoeff(), 1e-2);
}

TEST_F(KnownMap, TheProperRotationIsTheTurn) {
  EXPECT_LT((proper_rotation(pair_, truth_, 24) - turn_).cwiseAbs().maxCoeff(), 1e-4);
}

TEST_F(KnownMap, NearestNeighboursInTheEmbeddingAreTheMap) {
  const Eigen::MatrixXd c = functional_map(pair_, truth_, 40);
  const VertexMatches matches = match_vertices(pair_.dense, spectral_embedding(pair_, pair_.dense, c, 1), 1u << 20);
  for (int s = 0; s < 2; ++s) {
    ASSERT_EQ(matches.from[s].size(), pair_.shapes[s]->n_vertices());
    EXPECT_EQ(matches.from[s], matches.to[s]);
  }
}

TEST_F(KnownMap, TheTrueMapScoresZero) {
  const MapScore score = score_map(pair_, truth_, functional_map(pair_, truth_, 40));
  EXPECT_LT(score.functions, 1e-4);
  EXPECT_LT(score.signature, 1e-5);
  EXPECT_LT(score.orientation, 1e-5);
  EXPECT_LT(score.pose, 1e-4);
}

TEST_F(KnownMap, AMapThatReversesOrientationScoresOneThere) {
  const SpectralShape mirrored = mirrored_shape(*shape_1_);
  // The same points on the mirrored surface: normals pulled back through that map point inward.
  const ShapePairSpectra pair = make_shape_pair(mirrored, *shape_2_);
  const MapScore score = score_map(pair, truth_, functional_map(pair, truth_, 40));
  EXPECT_LT(score.functions, 1e-4);
  EXPECT_GT(score.orientation, 0.99);
  EXPECT_GT(score.pose, 0.05);
  EXPECT_NEAR(proper_rotation(pair, truth_, 24).determinant(), 1, 1e-12);
}

TEST_F(KnownMap, EveryPartOfTheScoreRisesForAWrongMap) {
  VertexMatches wrong = truth_;
  for (int s = 0; s < 2; ++s) std::rotate(wrong.to[s].begin(), wrong.to[s].begin() + 100, wrong.to[s].end());
  const MapScore score = score_map(pair_, wrong, functional_map(pair_, wrong, 40));
  EXPECT_GT(score.functions, 0.5);
  EXPECT_GT(score.signature, 0.02);
  EXPECT_GT(score.orientation, 0.2);
  EXPECT_GT(score.pose, 0.2);
}

}  // namespace
}  // namespace shellmatch
