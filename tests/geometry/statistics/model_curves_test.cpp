// Compactness, generalisation and specificity against their definitions: models fitted anew, shapes compared point by
// point.
#include "geometry/statistics/model_curves.h"

#include "base/error.h"
#include "tests/geometry/statistics/families.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace shellmatch {
namespace {

using testing::distance;
using testing::prescribed_scores;
using testing::random_sets;
using testing::random_weights;

struct MeanAndError {
  double mean, error;
};

MeanAndError statistics_of(const Eigen::VectorXd& values) {
  const double n = static_cast<double>(values.size()), mean = values.sum() / n;
  return {mean, std::sqrt((values.array() - mean).square().sum() / (n - 1)) / std::sqrt(n)};
}

// G(M): for each shape a model of all others.
MeanAndError generalisation(const PointSets& sets, const Eigen::VectorXd& weights, int n_modes) {
  const Eigen::Index n = sets.n_sets();
  Eigen::VectorXd distances(n);
  for (Eigen::Index left = 0; left < n; ++left) {
    PointSets others{sets.dimension, Eigen::MatrixXd(sets.coordinates.rows(), n - 1)};
    for (Eigen::Index i = 0, to = 0; i < n; ++i)
      if (i != left) others.coordinates.col(to++) = sets.coordinates.col(i);
    const ShapeModel model = fit_shape_model(others, weights, n_modes);
    const Eigen::MatrixXd best = model.inverse_transform(model.transform(sets.coordinates.col(left)));
    distances[left] = distance(best.col(0), sets.coordinates.col(left), weights);
  }
  return statistics_of(distances);
}

// S(M): random shapes as points.
MeanAndError specificity(const PointSets& sets, const Eigen::VectorXd& weights, Eigen::Index n_modes, int n_samples,
                         std::uint64_t seed) {
  const ShapeModel model = fit_shape_model(sets, weights);
  const Eigen::MatrixXd scores = model.sample_scores(n_samples, seed);
  const Eigen::MatrixXd shapes = model.inverse_transform(scores.leftCols(std::min(n_modes, scores.cols())));
  Eigen::VectorXd distances(n_samples);
  for (Eigen::Index s = 0; s < n_samples; ++s) {
    distances[s] = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < sets.n_sets(); ++i)
      distances[s] = std::min(distances[s], distance(shapes.col(s), sets.coordinates.col(i), weights));
  }
  return statistics_of(distances);
}

void expect_definitions(const PointSets& sets, double tolerance) {
  const Eigen::VectorXd weights = random_weights(sets.n_points(), 8);
  const auto n = static_cast<std::size_t>(sets.n_sets());
  const ModelCurves curves = model_curves(sets, weights, 25, 4);
  ASSERT_EQ(curves.compactness.size(), n - 1);
  ASSERT_EQ(curves.generalisation.size(), n - 2);
  ASSERT_EQ(curves.generalisation_error.size(), n - 2);
  ASSERT_EQ(curves.specificity.size(), n - 1);
  ASSERT_EQ(curves.specificity_error.size(), n - 1);
  const ShapeModel model = fit_shape_model(sets, weights);
  const double unit = std::sqrt(model.total_variance);
  for (std::size_t m = 1; m < n; ++m) {
    const Eigen::Index modes = std::min(static_cast<Eigen::Index>(m), model.variances.size());
    EXPECT_NEAR(curves.compactness[m - 1], model.variances.head(modes).sum() / model.total_variance, 1e-12);
    const MeanAndError s = specificity(sets, weights, static_cast<Eigen::Index>(m), 25, 4);
    EXPECT_NEAR(curves.specificity[m - 1], s.mean, tolerance * unit);
    EXPECT_NEAR(curves.specificity_error[m - 1], s.error, tolerance * unit);
    if (m == n - 1) continue;
    const MeanAndError g = generalisation(sets, weights, static_cast<int>(m));
    EXPECT_NEAR(curves.generalisation[m - 1], g.mean, tolerance * unit) << m;
    EXPECT_NEAR(curves.generalisation_error[m - 1], g.error, tolerance * unit) << m;
  }
}

TEST(ModelCurves, AreTheirDefinitions) {
  expect_definitions(random_sets(3, 7, 11, 3, 2), 1e-10);
  expect_definitions(random_sets(2, 9, 8, 5), 1e-10);
  expect_definitions(random_sets(2, 2, 12, 6), 1e-7);  // more shapes than coordinates
  expect_definitions(random_sets(3, 1, 9, 6), 1e-7);   // one point
  expect_definitions(random_sets(3, 7, 3, 6), 1e-10);
}

// The others then have a mode fewer than all, but for the two that are the same.
TEST(ModelCurves, WhereAShapeIsThereTwice) {
  PointSets sets = random_sets(3, 7, 8, 3, 2);
  sets.coordinates.col(5) = sets.coordinates.col(2);
  ASSERT_EQ(fit_shape_model(sets, uniform_weights(7)).variances.size(), 6);
  expect_definitions(sets, 1e-7);
  EXPECT_GT(model_curves(sets, uniform_weights(7), 1, 1).generalisation.back(), 0.1);
}

// Seven shapes on a line and one beside it. Of the first seven one mode leaves something as long as the eighth turns
// it, two leave nothing; of the eighth its distance from the line stays, whatever the number of modes.
TEST(ModelCurves, OfALineAndAShapeBesideIt) {
  PointSets sets = random_sets(3, 6, 8, 3);
  const Eigen::VectorXd weights = uniform_weights(6), start = sets.coordinates.col(0),
                        outlier = sets.coordinates.col(7);
  const Eigen::VectorXd direction = sets.coordinates.col(1).normalized();
  for (Eigen::Index i = 0; i < 7; ++i) sets.coordinates.col(i) = start + static_cast<double>(i) * direction;
  expect_definitions(sets, 1e-7);
  const Eigen::VectorXd from_line = outlier - start - direction * direction.dot(outlier - start);
  const ModelCurves curves = model_curves(sets, weights, 1, 1);
  for (std::size_t m = 2; m <= 6; ++m)
    EXPECT_NEAR(curves.generalisation[m - 1], distance(from_line, Eigen::VectorXd::Zero(18), weights) / 8, 1e-7);
}

TEST(ModelCurves, OfAFamilyWithTwoModes) {
  const testing::BoxFamily family = testing::box_family(3, 10);
  const ModelCurves curves = model_curves(family.shapes(prescribed_scores(12, {0.09, 0.01})), family.weights, 50, 1);
  EXPECT_NEAR(curves.compactness[0], 0.9, 1e-12);
  for (std::size_t m = 1; m < 11; ++m) EXPECT_EQ(curves.compactness[m], 1);
  for (std::size_t m = 1; m < 10; ++m) EXPECT_EQ(curves.generalisation[m], 0);  // the others span the family
  EXPECT_GT(curves.generalisation[0], 0.05);
  for (std::size_t m = 2; m < 11; ++m) EXPECT_EQ(curves.specificity[m], curves.specificity[1]);
}

TEST(ModelCurves, OfEqualShapes) {
  const PointSets one = random_sets(3, 5, 1, 3, 10);
  const ModelCurves curves = model_curves({3, one.coordinates.replicate(1, 5)}, uniform_weights(5), 10, 1);
  EXPECT_EQ(curves.compactness, std::vector<double>(4, 1));
  EXPECT_EQ(curves.generalisation, std::vector<double>(3, 0));
  EXPECT_EQ(curves.specificity, std::vector<double>(4, 0));
  EXPECT_EQ(curves.specificity_error, std::vector<double>(4, 0));
}

TEST(ModelCurves, OneSampleHasNoError) {
  const ModelCurves curves = model_curves(random_sets(3, 5, 5, 3), uniform_weights(5), 1, 1);
  EXPECT_EQ(curves.specificity_error, std::vector<double>(4, 0));
  EXPECT_GT(curves.specificity[0], 0);
}

std::string error_of_curves(const PointSets& sets, int n_samples) {
  try {
    model_curves(sets, uniform_weights(sets.n_points()), n_samples, 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

TEST(ModelCurves, SayWhatIsWrong) {
  PointSets sets = random_sets(3, 5, 4, 1);
  EXPECT_NE(error_of_curves(random_sets(3, 5, 2, 1), 10).find("at least three shapes; there are 2"), std::string::npos);
  EXPECT_NE(error_of_curves(random_sets(3, 5, 1, 1), 10).find("at least two shapes"), std::string::npos);
  EXPECT_NE(error_of_curves(sets, 0).find("0 random shapes"), std::string::npos);
  EXPECT_THROW(model_curves(fit_shape_model(sets, uniform_weights(5), 2), 10, 1), InputError);
  EXPECT_NO_THROW(model_curves(fit_shape_model(sets, uniform_weights(5), 3), 10, 1));
  sets.coordinates(4, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(error_of_curves(sets, 10).find("shape 3, point 1"), std::string::npos);
}

}  // namespace
}  // namespace shellmatch
