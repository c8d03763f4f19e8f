// Functional maps, rotations and scores of maps that are known.
#include "alignment/functional_map/map_search.h"
#include "geometry/distance/surface_distance.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
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

TEST_F(KnownMap, SmoothedCopiesAreCombinationsOfFunctions) {
  for (const int k : {4, 17, 40, 17}) {
    const Rows3 coefficients = shape_1_->coefficients.topRows(k),
                expected = shape_1_->functions.leftCols(k) * coefficients;
    for (const SmoothedSurface& s :
         {pair_.smoothed[0].with(k), pair_.smoothed[0].combined(coefficients, shape_1_->surface.facets)}) {
      EXPECT_LT((s.coordinates.topRows(3).transpose().cast<double>() - expected).cwiseAbs().maxCoeff(), 1e-5) << k;
      const Rows3 normals = vertex_normals(shape_1_->surface.facets, expected);
      EXPECT_LT((s.normals.topRows(3).transpose().cast<double>() - normals).cwiseAbs().maxCoeff(), 1e-3) << k;
    }
  }
}

// Of the other facets the normals of these vertices do not depend.
TEST_F(KnownMap, EmbeddingsOfSomeVerticesArePartsOfThoseOfAll) {
  const Eigen::MatrixXd c = functional_map(pair_, truth_, 12);
  const Embedding some = spectral_embedding(pair_, pair_.coarsest, c, embedded_normal_weight, 8),
                  all = dense_embedding(pair_, c, 8);
  ASSERT_LT(pair_.coarsest[0].facets.size(), shape_1_->surface.facets.size());
  for (int s = 0; s < 2; ++s)
    for (std::size_t i = 0; i < pair_.coarsest[s].size(); ++i)
      EXPECT_LT((some.on[s].col(static_cast<Eigen::Index>(i)) - all.on[s].col(pair_.coarsest[s].vertices[i])).norm(),
                1e-4);
}

// A turn changes neither spin images nor their components, which tell points apart where functions say nothing.
TEST_F(KnownMap, LocalFeaturesAloneFindMostVertices) {
  const Embedding embedding = spectral_embedding(pair_, pair_.dense, Eigen::MatrixXd::Zero(1, 1), 0, 8);
  const Eigen::Index p = pair_.local[0].rows();
  ASSERT_EQ(embedding.on[0].rows(), 1 + p);
  Embedding local;
  for (int s = 0; s < 2; ++s) local.on[s] = embedding.on[s].bottomRows(p);
  const VertexMatches matches = match_vertices(pair_.dense, local, 1u << 20);
  std::size_t n_right = 0;
  for (std::size_t i = 0; i < matches.from[0].size(); ++i) n_right += matches.to[0][i] == matches.from[0][i];
  EXPECT_GT(n_right, matches.from[0].size() * 9 / 10);
  EXPECT_NEAR(local.on[0].col(0).norm(), 8 * pair_.local[0].col(pair_.dense[0].vertices[0]).norm(), 1e-4);
}

TEST_F(KnownMap, LocalFeaturesWeighLessTheMoreExactlyFunctionsFit) {
  const Eigen::MatrixXd c = functional_map(pair_, truth_, 40);
  VertexMatches wrong = truth_;
  for (int s = 0; s < 2; ++s) std::rotate(wrong.to[s].begin(), wrong.to[s].begin() + 100, wrong.to[s].end());
  const auto weight = [&](float scale) {
    ShapePairSpectra scaled = pair_;
    for (Features& functions : scaled.functions) functions *= scale;
    return local_weight(scaled, wrong, c);
  };
  EXPECT_NEAR(weight(1), 8 * std::sqrt(static_cast<double>(shape_1_->n_vertices()) / 5000), 1e-12);
  EXPECT_LT(weight(1e-3f), 1);
  EXPECT_NEAR(weight(1e-3f) / weight(1e-4f), 10, 1e-3);
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
  // Nearly orthonormal columns: normal equations are exact enough.
  const auto least_squares = [](const Eigen::MatrixXd& from, const Eigen::MatrixXd& to) {
    return Eigen::MatrixXd(Eigen::MatrixXd(from.transpose() * from).llt().solve(from.transpose() * to));
  };
  const Eigen::MatrixXd forward = least_squares(a, b), backward = least_squares(b, a);
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

TEST_F(KnownMap, LandmarksAreTheFirstOfAllSets) {
  const std::vector<std::pair<Index, Index>> four{{7, 7}, {900, 900}, {3, 3}, {55, 55}};
  std::vector<std::pair<Index, Index>> with_doubles = four;
  with_doubles.insert(with_doubles.begin() + 2, {{7, 8}, {9, 900}});
  const ShapePairSpectra pair = make_shape_pair(*shape_1_, *shape_2_, with_doubles);
  EXPECT_EQ(pair.landmarks, four);
  for (int s = 0; s < 2; ++s)
    for (const VertexSet* set : {&pair.coarsest[s], &pair.coarse[s], &pair.dense[s]}) {
      EXPECT_EQ(std::vector<Index>(set->vertices.begin(), set->vertices.begin() + 4),
                (std::vector<Index>{7, 900, 3, 55}));
      std::vector<Index> sorted = set->vertices;
      std::ranges::sort(sorted);
      EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end());
    }
  EXPECT_EQ(pair.dense[0].size(), shape_1_->n_vertices());
  EXPECT_TRUE(make_shape_pair(*shape_1_, *shape_2_, {four.begin(), four.end() - 1}).landmarks.empty());
}

TEST_F(KnownMap, LandmarksWeighAsPairsDo) {
  ShapePairSpectra pair = make_shape_pair(*shape_1_, *shape_2_, {{0, 10}, {20, 30}, {40, 50}, {60, 70}});
  // A landmark that weighs as much as one of the pairs is one more pair.
  VertexMatches more = truth_;
  for (const auto& [p, q] : pair.landmarks) {
    more.from[0].push_back(p);
    more.to[0].push_back(q);
  }
  const std::vector<double> weights(4, 1.0 / static_cast<double>(pairs_of(truth_).size()));
  const Eigen::MatrixXd plain = functional_map(pair, truth_, 12), c = functional_map(pair, truth_, 12, weights);
  EXPECT_GT((c - plain).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LT((c - functional_map(pair, more, 12)).cwiseAbs().maxCoeff(), 1e-5);
}

TEST_F(KnownMap, LandmarksTellTheMedianOfTheirDistances) {
  ShapePairSpectra pair = make_shape_pair(*shape_1_, *shape_2_, {{0, 0}, {20, 20}, {40, 40}, {60, 700}, {80, 80}});
  VertexMatches matches;
  for (int s = 0; s < 2; ++s) matches.from[s] = matches.to[s] = pair.dense[s].vertices;
  // The fourth belongs elsewhere: its vertex of surface 2 is not the image of its own.
  const Eigen::MatrixXd c = functional_map(pair, matches, 40);
  EXPECT_EQ(score_map(pair, matches, c).landmarks, 0);
  std::vector<double> distances = landmark_distances(pair, matches);
  EXPECT_NEAR(distances[3], (shape_2_->surface.vertices[60] - shape_2_->surface.vertices[700]).norm(), 1e-12);
  for (int i : {0, 1, 2, 4}) EXPECT_EQ(distances[static_cast<std::size_t>(i)], 0);
  for (std::size_t j = 0; j < 3; ++j) matches.to[1][j] = 700;
  EXPECT_GT(score_map(pair, matches, c).landmarks, 0.05) << "on either surface";
}

TEST_F(KnownMap, NoiseOfFewLandmarksIsThatAtNoDistance) {
  std::vector<std::pair<Index, Index>> landmarks;
  const auto step = static_cast<Index>(shape_1_->n_vertices() / 16);
  for (Index k = 0; k < 16; ++k) landmarks.emplace_back(step * k, step * k);
  const ShapePairSpectra pair = make_shape_pair(*shape_1_, *shape_2_, landmarks);
  VertexMatches matches;
  for (int s = 0; s < 2; ++s) matches.from[s] = matches.to[s] = pair.dense[s].vertices;
  // A map that is turned: its errors differ from one landmark to the next, the more the farther they are.
  const auto& vertices = shape_2_->surface.vertices;
  const Mat<3> turn = Eigen::AngleAxisd(0.4, Vec<3>(1, 2, 3).normalized()).toRotationMatrix();
  for (std::size_t j = 0; j < 16; ++j) {
    const Vec<3> x = turn * vertices[pair.landmarks[j].second];
    matches.to[0][j] = static_cast<Index>(
        std::ranges::min_element(vertices, {}, [&](const Vec<3>& v) { return (v - x).squaredNorm(); }) -
        vertices.begin());
  }
  const MapScore turned = score_map(pair, matches, functional_map(pair, matches, 40));
  EXPECT_GT(turned.landmarks, 0.05);
  EXPECT_LT(turned.landmark_noise, 0.35 * turned.landmarks);
}

TEST_F(KnownMap, NoiseOfLandmarksIsWhatNeighboursDoNotShare) {
  std::vector<std::pair<Index, Index>> landmarks;
  const auto step = static_cast<Index>(shape_1_->n_vertices() / 60);
  for (Index k = 0; k < 60; ++k) landmarks.emplace_back(step * k, step * k);
  const ShapePairSpectra pair = make_shape_pair(*shape_1_, *shape_2_, landmarks);
  VertexMatches matches;
  for (int s = 0; s < 2; ++s) matches.from[s] = matches.to[s] = pair.dense[s].vertices;
  const Eigen::MatrixXd c = functional_map(pair, matches, 40);
  EXPECT_EQ(score_map(pair, matches, c).landmark_noise, 0);
  // All images are those of a neighbour in one direction: an error that is shared.
  const auto& vertices = shape_2_->surface.vertices;
  const auto nearest = [&](const Vec<3>& x) {
    return static_cast<Index>(
        std::ranges::min_element(vertices, {}, [&](const Vec<3>& v) { return (v - x).squaredNorm(); }) -
        vertices.begin());
  };
  for (std::size_t j = 0; j < 60; ++j) matches.to[0][j] = nearest(vertices[matches.to[0][j]] + Vec<3>(0.06, 0, 0));
  const MapScore shared = score_map(pair, matches, c);
  EXPECT_GT(shared.landmarks, 0.03);
  EXPECT_LT(shared.landmark_noise, 0.6 * shared.landmarks);
  // Now each in a direction of its own.
  for (std::size_t j = 0; j < 60; ++j) {
    const Vec<3> away =
        Eigen::AngleAxisd(static_cast<double>(j * j), Vec<3>(1, 2, 3).normalized()) * Vec<3>(0.06, 0, 0);
    matches.to[0][j] = nearest(vertices[pair.landmarks[j].second] + away);
  }
  const MapScore noisy = score_map(pair, matches, c);
  EXPECT_GT(noisy.landmark_noise, 0.8 * noisy.landmarks);
}

TEST(LandmarkTrust, IsFullForWhatTheMapsErrorsExplain) {
  EXPECT_EQ(landmark_trust(0.5, 0.02), 1);
  EXPECT_EQ(landmark_trust(0.85, 0.05), 1);
  EXPECT_LT(landmark_trust(0.5, 0.037), 0.01);
  EXPECT_LT(landmark_trust(0.5, 0.1), 1e-6);
  EXPECT_GT(landmark_trust(0.5, 0.026), 0.7);
  EXPECT_EQ(error_growth(0.5), 1);
  EXPECT_NEAR(error_growth(1.2), 8, 1e-12);
}

TEST_F(KnownMap, MarginsAreJudgedWhereMapsDiffer) {
  // The images of samples below a share of the height are those of other samples.
  const auto wrong_below = [&](double share, std::size_t shift) {
    MapCandidate map;
    map.matches = truth_;
    for (int s = 0; s < 2; ++s) {
      std::vector<double> heights;
      for (const Index v : truth_.from[s]) heights.push_back(shape_1_->surface.vertices[v][0]);
      const double limit = quantile(heights, share);
      const std::size_t n = heights.size();
      for (std::size_t i = 0; i < n; ++i)
        if (heights[i] <= limit) map.matches.to[s][i] = truth_.to[s][(i + shift) % n];
    }
    map.c = functional_map(pair_, truth_, 40);
    map.coarse_score = map.score = score_map(pair_, map.matches, map.c);
    return map;
  };
  const MapCandidate first = wrong_below(0.5, 100), worse = wrong_below(0.6, 100), other = wrong_below(0.5, 200);
  const double overall = worse.order() / first.order();
  EXPECT_LT(overall, 2);
  EXPECT_GT(margin_between(pair_, first, worse), 5 * overall) << "right and wrong where they differ";
  EXPECT_NEAR(margin_between(pair_, first, worse) * margin_between(pair_, worse, first), 1, 1e-9);
  EXPECT_EQ(margin_between(pair_, first, first), 1);
  // Wrong alike where they differ, and right elsewhere.
  EXPECT_NEAR(margin_between(pair_, first, other), other.order() / first.order(), 0.1);
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
