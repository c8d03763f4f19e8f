// Shape models of families whose modes and variances are known.
#include "geometry/statistics/shape_model.h"

#include "base/error.h"
#include "geometry/statistics/procrustes.h"
#include "tests/geometry/statistics/families.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace shellmatch {
namespace {

using testing::box_family;
using testing::BoxFamily;
using testing::distance;
using testing::prescribed_scores;
using testing::random_sets;
using testing::random_weights;
using testing::Sphere;
using testing::sphere;

double inner(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& weights) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(a.size());
  return (std::pow(distance(a, -b, weights), 2) - std::pow(distance(a, b, weights), 2)) / 4;
}

double angle_in_degrees(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& weights) {
  return std::acos(std::min(1.0, std::abs(inner(a, b, weights)))) * 180 / std::numbers::pi;
}

void expect_orthonormal(const ShapeModel& model, double tolerance) {
  for (Eigen::Index i = 0; i < model.modes.cols(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      EXPECT_NEAR(inner(model.modes.col(i), model.modes.col(j), model.weights), i == j ? 1 : 0, tolerance)
          << i << " " << j;
}

TEST(ShapeModel, OfPrescribedScoresIsExact) {
  for (const int dimension : {2, 3}) {
    const BoxFamily family = box_family(dimension, 40);
    const Eigen::MatrixXd scores = prescribed_scores(30, {0.25, 0.04});
    const ShapeModel model = fit_shape_model(family.shapes(scores), family.weights);
    ASSERT_EQ(model.variances.size(), 2);
    EXPECT_NEAR(model.variances[0], 0.25, 1e-13);
    EXPECT_NEAR(model.variances[1], 0.04, 1e-13);
    EXPECT_NEAR(model.total_variance, 0.29, 1e-13);
    EXPECT_LE(distance(model.mean, family.mean, family.weights), 1e-13);
    for (Eigen::Index k = 0; k < 2; ++k) {
      const double sign = inner(model.modes.col(k), family.modes.col(k), family.weights);
      EXPECT_LE(distance(sign * model.modes.col(k), family.modes.col(k), family.weights), 1e-12);
      EXPECT_LE((sign * model.scores.col(k) - scores.col(k)).norm(), 1e-12);
    }
    expect_orthonormal(model, 1e-13);
  }
}

// Four points on the axes, far from the origin, and one mode with standard deviation 1 along `mode`.
ShapeModel cross_model(const Eigen::VectorXd& mode) {
  Eigen::VectorXd cross(8);
  cross << 11, 7, 9, 7, 10, 8, 10, 6;
  PointSets sets{2, Eigen::MatrixXd(8, 3)};
  for (int i = 0; i < 3; ++i) sets.coordinates.col(i) = cross + (i - 1) * 0.1 * mode;
  return fit_shape_model(sets, Eigen::VectorXd::Constant(4, 0.25));
}

TEST(ShapeModel, PositiveScoresAreLargerShapes) {
  for (const double sign : {1.0, -1.0}) {
    // Wider: the entries of greatest magnitude are -1 and 1, as equal as rounding leaves them.
    for (const double rounding : {0.0, 1e-12, -1e-12}) {
      Eigen::VectorXd wider = Eigen::VectorXd::Zero(8);
      wider[0] = sign * (1 + rounding);
      wider[2] = -sign;
      const ShapeModel model = cross_model(wider);
      ASSERT_EQ(model.variances.size(), 1);
      EXPECT_GT(model.modes(0, 0), 0);
      EXPECT_GT(model.scores(2, 0) * sign, 0);
      EXPECT_LT(model.modes(2, 0), 0);
    }
    // What leaves the size alone, a turn to begin with.
    for (const double rounding : {0.0, 1e-12, -1e-12}) {
      Eigen::VectorXd turn(8);
      turn << 0, sign * (1 + rounding), 0, -sign, -sign, 0, sign, 0;
      EXPECT_GT(cross_model(turn).modes(1, 0), 0);
    }
  }
}

// Normal scores from the points of a lattice in the square, so that their moments are close to those of the
// distribution (J. M. Hammersley 1960), noise, and a motion of each shape.
TEST(ShapeModel, OfRandomShapesIsThatOfTheFamily) {
  const BoxFamily family = box_family(3, 15);
  constexpr Eigen::Index n = 512;
  Eigen::MatrixXd scores(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    double reversed = 0, half = 0.5;
    for (Eigen::Index bits = i; bits > 0; bits >>= 1, half /= 2) reversed += static_cast<double>(bits & 1) * half;
    const double radius = std::sqrt(-2 * std::log((static_cast<double>(i) + 0.5) / n)),
                 angle = 2 * std::numbers::pi * reversed;
    scores.row(i) << 0.5 * radius * std::cos(angle), 0.3 * radius * std::sin(angle);
  }
  PointSets shapes = family.shapes(scores);
  shapes.coordinates += 0.02 * random_sets(3, shapes.n_points(), n, 5).coordinates;
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vec<3> a(normal(random), normal(random), normal(random)), b(normal(random), normal(random), normal(random));
    const Mat<3> one = Mat<3>::Identity(), turn = (one - 2 / a.squaredNorm() * a * a.transpose()) *
                                                  (one - 2 / b.squaredNorm() * b * b.transpose());
    for (Eigen::Index p = 0; p < shapes.n_points(); ++p) {
      auto x = shapes.coordinates.col(i).segment<3>(3 * p);
      x = (turn * x + 10 * a).eval();
    }
  }
  const AlignedSets aligned = procrustes(shapes, family.weights, family.mean, ProcrustesKind::rigid);
  const ShapeModel model = fit_shape_model(aligned.sets, family.weights, 2);
  EXPECT_NEAR(model.variances[0], 0.25, 0.02 * 0.25);
  EXPECT_NEAR(model.variances[1], 0.09, 0.02 * 0.09);
  EXPECT_LE(angle_in_degrees(model.modes.col(0), family.modes.col(0), family.weights), 2);
  EXPECT_LE(angle_in_degrees(model.modes.col(1), family.modes.col(1), family.weights), 2);
  EXPECT_LE(distance(model.mean, family.mean, family.weights), 0.01);
}

// A field on the sphere, x -> x + b1 (x, 0, 0) + b2 z (0, 0, 1) / 1 and so on: variances are integrals over the sphere.
ShapeModel model_on(const Sphere& s, const Eigen::VectorXd& weights) {
  const Eigen::MatrixXd scores = prescribed_scores(20, {0.09, 0.01});
  PointSets sets{3, s.points.replicate(1, scores.rows())};
  for (Eigen::Index i = 0; i < scores.rows(); ++i)
    for (Eigen::Index p = 0; p < sets.n_points(); ++p) {
      const Vec<3> x = s.points.segment<3>(3 * p);
      sets.coordinates(3 * p, i) += scores(i, 0) * x[2];            // shear, of mean square 1/3
      sets.coordinates(3 * p + 2, i) += scores(i, 1) * (1 + x[2]);  // one pole moves, of mean square 4/3
    }
  return fit_shape_model(sets, weights);
}

TEST(ShapeModel, DoesNotDependOnHowTheSurfaceIsSampled) {
  const Sphere even = sphere(40, 1), uneven = sphere(40, 2.5);
  const Eigen::VectorXd even_weights = area_weights<3>(even.points, even.triangles);
  const Eigen::VectorXd uneven_weights = area_weights<3>(uneven.points, uneven.triangles);
  EXPECT_GT(uneven_weights.maxCoeff() / uneven_weights.segment(1, 200).minCoeff(), 1000);
  for (const ShapeModel& model : {model_on(even, even_weights), model_on(uneven, uneven_weights)}) {
    ASSERT_EQ(model.variances.size(), 2);
    EXPECT_NEAR(model.variances[0], 0.09 / 3, 0.01 * 0.03);
    EXPECT_NEAR(model.variances[1], 0.01 * 4 / 3, 0.01 * 0.01);
  }
  // Without weights the crowded pole counts most.
  const ShapeModel unweighted = model_on(uneven, uniform_weights(uneven.points.size() / 3));
  EXPECT_GT(std::abs(unweighted.variances[0] - 0.03), 0.2 * 0.03);
}

TEST(ShapeModel, ScoresAndShapesAreInverse) {
  const PointSets sets = random_sets(3, 12, 9, 7, 4);
  const Eigen::VectorXd weights = random_weights(12, 8);
  const ShapeModel model = fit_shape_model(sets, weights);
  ASSERT_EQ(model.variances.size(), 8);
  expect_orthonormal(model, 1e-13);
  EXPECT_LE((model.transform(sets.coordinates) - model.scores).norm(), 1e-12);
  EXPECT_LE((model.inverse_transform(model.scores) - sets.coordinates).norm(), 1e-11);
  EXPECT_NEAR(model.variances.sum(), model.total_variance, 1e-12);
  const Eigen::MatrixXd products = model.scores.transpose() * model.scores / 8.0;
  EXPECT_LE((products - Eigen::MatrixXd(model.variances.asDiagonal())).norm(), 1e-12);
  for (Eigen::Index k = 1; k < 8; ++k) EXPECT_LE(model.variances[k], model.variances[k - 1]);
  Eigen::VectorXd about_centre = model.mean;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<3>> coordinate(about_centre.data() + i, 12);
    const double centre = coordinate.dot(weights);
    for (int p = 0; p < 12; ++p) about_centre[3 * p + i] -= centre;
  }
  for (Eigen::Index k = 0; k < 8; ++k)
    EXPECT_GT(inner(model.modes.col(k), about_centre, weights),
              -0.01 * std::sqrt(inner(about_centre, about_centre, weights)));
  // Fewer scores are those of the first modes.
  const Eigen::MatrixXd two = model.inverse_transform(model.scores.leftCols(2));
  EXPECT_LE((model.transform(two).leftCols(2) - model.scores.leftCols(2)).norm(), 1e-12);
  EXPECT_LE(model.transform(two).rightCols(6).norm(), 1e-12);
}

TEST(ShapeModel, ALimitedModelHasTheFirstModes) {
  const PointSets sets = random_sets(2, 30, 9, 7);
  const Eigen::VectorXd weights = random_weights(30, 8);
  const ShapeModel all = fit_shape_model(sets, weights), three = fit_shape_model(sets, weights, 3),
                   many = fit_shape_model(sets, weights, 50);
  EXPECT_EQ(three.variances.size(), 3);
  EXPECT_EQ(many.variances.size(), 8);
  EXPECT_LE((three.modes - all.modes.leftCols(3)).norm(), 1e-12);
  EXPECT_LE((three.scores - all.scores.leftCols(3)).norm(), 1e-12);
  EXPECT_NEAR(three.total_variance, all.total_variance, 1e-14);
}

// Variances far apart: modes that much cancels in are as orthonormal as others, and what is below rounding is none.
TEST(ShapeModel, SmallModesKeepTheirDigits) {
  const BoxFamily family = box_family(3, 20);
  const Eigen::MatrixXd scores = prescribed_scores(20, {1, 1e-6, 1e-11});
  const ShapeModel model = fit_shape_model(family.shapes(scores), family.weights);
  ASSERT_EQ(model.variances.size(), 3);
  expect_orthonormal(model, 1e-13);
  EXPECT_NEAR(model.variances[1], 1e-6, 1e-8 * 1e-6);
  EXPECT_NEAR(model.variances[2], 1e-11, 1e-3 * 1e-11);
  EXPECT_EQ(fit_shape_model(family.shapes(prescribed_scores(20, {1, 1e-14})), family.weights).variances.size(), 1);
}

TEST(ShapeModel, SamplesHaveItsVariances) {
  const ShapeModel model = fit_shape_model(random_sets(3, 12, 6, 7), uniform_weights(12));
  constexpr int n = 20'000;
  const Eigen::MatrixXd samples = model.sample_scores(n, 9);
  ASSERT_EQ(samples.cols(), 5);
  for (Eigen::Index k = 0; k < 5; ++k) {
    EXPECT_NEAR(samples.col(k).mean(), 0, 5 * std::sqrt(model.variances[k] / n));
    EXPECT_NEAR(samples.col(k).squaredNorm() / n, model.variances[k], 5 * model.variances[k] * std::sqrt(2.0 / n));
  }
  EXPECT_LE(std::abs(samples.col(0).dot(samples.col(1))) / n,
            5 * std::sqrt(model.variances[0] * model.variances[1] / n));
  EXPECT_EQ(model.sample_scores(10, 9), samples.topRows(10));
  EXPECT_NE(model.sample_scores(10, 10), samples.topRows(10));
  EXPECT_EQ(model.sample_scores(0, 9).rows(), 0);
}

TEST(ShapeModel, OfFewOrEqualShapes) {
  const ShapeModel two = fit_shape_model(random_sets(3, 12, 2, 7), uniform_weights(12));
  EXPECT_EQ(two.variances.size(), 1);
  EXPECT_NEAR(two.variances[0], two.total_variance, 1e-14);
  const PointSets one = random_sets(3, 12, 1, 7, 1000);
  const ShapeModel equal = fit_shape_model({3, one.coordinates.replicate(1, 6)}, uniform_weights(12));
  EXPECT_EQ(equal.variances.size(), 0);
  EXPECT_EQ(equal.total_variance, 0);
  EXPECT_EQ(equal.scores.rows(), 6);
  EXPECT_EQ(equal.inverse_transform(equal.sample_scores(2, 1)), one.coordinates.replicate(1, 2));
  // Equal to rounding: after a motion of each.
  PointSets turned{3, one.coordinates.replicate(1, 6)};
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double c = std::cos(static_cast<double>(i)), s = std::sin(static_cast<double>(i));
    const Mat<3> turn = (Mat<3>() << c, -s, 0, s, c, 0, 0, 0, 1).finished();
    for (Eigen::Index p = 0; p < 12; ++p)
      turned.coordinates.col(i).segment<3>(3 * p) = turn * one.coordinates.col(0).segment<3>(3 * p);
  }
  const AlignedSets aligned = procrustes(turned, uniform_weights(12), one.coordinates.col(0), ProcrustesKind::rigid);
  EXPECT_GT((aligned.sets.coordinates.col(0) - aligned.sets.coordinates.col(5)).norm(), 0);
  EXPECT_EQ(fit_shape_model(aligned.sets, uniform_weights(12)).variances.size(), 0);
  const ShapeModel point = fit_shape_model(random_sets(3, 1, 9, 7), uniform_weights(1));
  EXPECT_EQ(point.variances.size(), 3);
}

template <class Call>
std::string error_of_model(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

TEST(ShapeModel, SaysWhatIsWrong) {
  PointSets sets = random_sets(3, 5, 4, 1);
  const Eigen::VectorXd weights = uniform_weights(5);
  const ShapeModel model = fit_shape_model(sets, weights);
  EXPECT_EQ(error_of_model([&] { fit_shape_model(random_sets(3, 5, 1, 1), weights); }),
            "a shape model needs at least two shapes; there is one");
  EXPECT_NE(error_of_model([&] { fit_shape_model(sets, weights, -1); }).find("-1 modes"), std::string::npos);
  EXPECT_NE(error_of_model([&] { model.transform(Eigen::MatrixXd::Zero(12, 2)); }).find("12 coordinates"),
            std::string::npos);
  EXPECT_NE(error_of_model([&] { model.inverse_transform(Eigen::MatrixXd::Zero(2, 4)); }).find("4 modes"),
            std::string::npos);
  EXPECT_NE(error_of_model([&] { model.sample_scores(-1, 1); }).find("-1 random shapes"), std::string::npos);
  sets.coordinates(4, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(error_of_model([&] { fit_shape_model(sets, weights); }).find("shape 3, point 1"), std::string::npos);
}

}  // namespace
}  // namespace shellmatch
